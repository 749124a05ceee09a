// The diagrams of chapter 05 show what its formulas say.
