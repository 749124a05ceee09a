// The diagrams of chapter 10 show what its formulas say.
