"""Runs scree, a discrete-element laboratory for granular matter, and reads its results: see README.md."""
from . import charts, documents, fits, scripts, values
from .campaigns import Campaign, read
from .errors import Error
from .program import find_program
from .results import Result
from .runs import run, study
from .states import State, contacts
from .tables import read_table

__all__ = ["Campaign", "Error", "Result", "State", "charts", "contacts", "documents", "find_program", "fits", "read",
           "read_table", "run", "scripts", "study", "values"]
