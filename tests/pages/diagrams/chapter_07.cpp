// The diagrams of chapter 07 show what its formulas say.
