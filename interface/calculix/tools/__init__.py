"""What run, contact and the studies of examples/calculix are made of. Python 3 alone is needed."""
