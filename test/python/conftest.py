"""What the tests of the Python package share, and their closing line."""

import asperity
import pytest


def wood(**changes):
    """The paper's first pair."""
    return asperity.Properties.from_pair("transverse-tangential", **changes)


@pytest.fixture(scope="session")
def law():
    """The paper's first pair, compiled."""
    return asperity.Law(wood(compiled=True))


def pytest_unconfigure(config):
    """The line that the project's other tests end with."""
    reporter = config.pluginmanager.get_plugin("terminalreporter")
    if reporter is not None:
        numbers = {name: len(reporter.stats.get(name, [])) for name in ("passed", "failed", "error")}
        print(f"{numbers['passed']} passed, {numbers['failed'] + numbers['error']} failed")
