// The diagrams of chapter 13 show what its formulas say.
