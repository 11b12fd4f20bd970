"""Back-analysis of rock-slope failures by sliding and toppling.

    import delabole

    case = delabole.read("my_slope.toml")
    print(case.run().factor_of_safety)

Numbers are texts with a unit ("30 deg", "12 m") or SI numbers where they go in, and SI numbers where they come out:
metres, radians, pascals, newtons per metre run. Models are classes whose keywords are the keys of case files; what is
wrong raises CaseError, whose attribute `problems` lists it.
"""

from ._delabole import CaseError as CaseError, __version__ as __version__
from .case import Case as Case, Model as Model, case as case, parse as parse, read as read
from .fields import Section as Section
from .models import *
from .results import (Evaluation as Evaluation, FailureLocus as FailureLocus, Fit as Fit, MechanismFit as MechanismFit,
                      MisfitMap as MisfitMap, Posterior as Posterior, ProfileLikelihood as ProfileLikelihood,
                      Result as Result, Sensitivity as Sensitivity)
from .simulation import Simulation as Simulation, blocks as blocks
