// The diagrams of chapter 09 show what its formulas say.
