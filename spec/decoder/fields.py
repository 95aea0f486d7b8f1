def FLD_numbers(*a): raise NotImplementedError
def ATTR_9_means(*a): raise NotImplementedError("ATTR-9")
