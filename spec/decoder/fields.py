def FLD_numbers(*a): raise NotImplementedError
