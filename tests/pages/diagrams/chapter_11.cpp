// The diagrams of chapter 11 show what its formulas say.
