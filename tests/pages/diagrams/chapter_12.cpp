// The diagrams of chapter 12 show what its formulas say.
