#!/usr/bin/env python3
"""Reference values of summits that stick before they slide, for test/data/stick_reference.csv.

    python3 stick_reference.py > OUTPUT.csv

It needs mpmath. Units N-mm-MPa. Mindlin's curve of one summit,
T = mu N (1 - (1 - delta/delta_i)^(3/2)), delta_i = 3 mu N/(16 G* a), a = sqrt(A/pi), with N and A
of Eqs 1-22 at its deformation w, is summed over Gaussian heights by mpmath's tanh-sinh
quadrature in sqrt(w), in panels that end at w1, w2 and at the last summit that
slides, doubled until two results agree to 1e-13. Inputs are the doubles of the text.

Columns: separation d in sigma; unit_slip, the slip over mu; share, shear stress over mu p;
stiffness, eta times the sum of 8 G* a.
"""
import mpmath as mp

mp.mp.dps = 25
PAIRS = {"transverse-tangential": ("206.0", "297.0", "0.1477", "24.53", "0.4", "0.0593"),
         "tangential-tangential": ("134.0", "263.0", "0.1142", "12.14", "0.4", "0.0416")}
SHEAR_MODULUS = "31.6"
W1_OVER_SIGMA = 0.001, 0.01, 0.1, 1.0
PARTS_OF_SLIP = 0.1, 0.5, 1.0, 2.0


def exact(text):
    return mp.mpf(float(text))


class Face:
    def __init__(self, eta, modulus, radius, hardness, yield_factor, sigma):
        self.eta, self.modulus, self.radius, self.hardness, self.k, self.sigma = map(
            exact, (eta, modulus, radius, hardness, yield_factor, sigma))
        self.g = exact(SHEAR_MODULUS)
        self.w1 = (3*mp.pi*self.k*self.hardness/(4*self.modulus))**2*self.radius
        self.w2 = 110*self.w1
        self.b2 = 1 + mp.log(2)/mp.log(110)
        self.b3 = self.b2 + mp.log(1/self.k)/mp.log(110)

    def summit(self, w):
        """Force and contact radius."""
        if w < self.w1:
            force = mp.mpf(4)/3*self.modulus*mp.sqrt(self.radius)*w**1.5
            area = mp.pi*self.radius*w
        elif w < self.w2:
            force = mp.pi*self.k*self.hardness*self.radius*self.w1*(w/self.w1)**self.b3
            area = mp.pi*self.radius*self.w1*(w/self.w1)**self.b2
        else:
            force = 2*mp.pi*self.radius*self.hardness*w
            area = 2*mp.pi*self.radius*w
        return force, mp.sqrt(area/mp.pi)

    def critical(self, w):
        force, radius = self.summit(w)
        return 3*force/(16*self.g*radius)

    def total(self, d, function, ends=()):
        """eta times the integral over heights, of a function of w."""
        far = mp.sqrt(max(d, 0)**2 + 120*self.sigma**2) - d
        middle = max(-d, 0)
        points = [0, self.w1, self.w2, *ends, far, *(middle + i*self.sigma for i in range(-4, 5, 2))]
        points = sorted({mp.sqrt(w) for w in points if 0 <= w <= far})

        def integrand(x):
            w = x*x
            z = (d + w)/self.sigma
            return 2*x*function(w)*mp.exp(-z*z/2)
        for degree in range(4, 9):
            value = mp.quad(integrand, points, maxdegree=degree)
            if degree > 4 and abs(value - before) <= mp.mpf(10)**-13*abs(value):
                return self.eta*value/mp.sqrt(2*mp.pi)/self.sigma
            before = value
        raise SystemExit("no agreement")

    def row(self, d, part):
        pressure = self.total(d, lambda w: self.summit(w)[0])
        stiffness = self.total(d, lambda w: 8*self.g*self.summit(w)[1])
        slip = exact(f"{float(part*pressure/stiffness):.6g}")

        def shear(w):
            left = 1 - slip/self.critical(w) if w > 0 else 0
            return self.summit(w)[0]*(1 - (left**1.5 if left > 0 else 0))
        last = mp.mpf(0)
        high = self.w2*1000 + 100*self.sigma
        if self.critical(high) > slip:
            low = mp.mpf(0)
            for _ in range(90):
                last = (low + high)/2
                low, high = (last, high) if self.critical(last) < slip else (low, last)
        share = self.total(d, shear, (last,))/pressure
        return slip, share, stiffness


def main():
    print("eta,modulus,radius,hardness,yield_factor,sigma,shear_modulus,h,unit_slip,share,stiffness")
    for values in PAIRS.values():
        faces = [values]
        if values is PAIRS["transverse-tangential"]:
            for ratio in W1_OVER_SIGMA:
                hardness = (ratio*float(values[5])/float(values[2]))**0.5*float(values[1])*4 \
                    / (3*3.141592653589793*float(values[4]))
                faces.append((*values[:3], f"{hardness:.6g}", *values[4:]))
        for face in faces:
            rough = Face(*face)
            for h in range(-2, 7):
                d = exact(f"{h}")*rough.sigma
                for part in PARTS_OF_SLIP:
                    slip, share, stiffness = rough.row(d, part)
                    print(*face, SHEAR_MODULUS, h, mp.nstr(slip, 6), mp.nstr(share, 13),
                          mp.nstr(stiffness, 13), sep=",", flush=True)


main()
