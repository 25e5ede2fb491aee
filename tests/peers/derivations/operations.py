"""The number of operations of expressions, counted in the same way for all tools: as written, and after SymPy's search for common
subexpressions.

A sum of n terms is n - 1 operations, a product of n factors n - 1 operations, an integer power as many successive products as its
exponent needs. A division, a function and a root are one operation each. Signs are free.
"""

import sympy as sp


def operations(expressions):
    """The number of operations of SymPy expressions."""
    return sum(of(expression) for expression in expressions)


def of(e):
    if not e.args:
        return 0
    inner = sum(of(argument) for argument in e.args)
    if e.is_Add:
        return inner + len(e.args) - 1
    if e.is_Mul:
        return inner + len([factor for factor in e.args if factor != -1]) - 1
    if e.is_Pow and e.exp.is_Integer:
        return of(e.base) + max(abs(int(e.exp)) - 1, 0) + int(e.exp.is_negative)
    return inner + 1


def counted(expressions):
    """Yields the number of operations as written, then after common subexpressions."""
    expressions = [sp.sympify(e) for e in expressions]
    yield {"before": operations(expressions)}
    shared, rest = sp.cse(expressions)
    yield {"after": operations([e for _, e in shared] + rest)}
