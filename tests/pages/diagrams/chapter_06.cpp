// The diagrams of chapter 06 show what its formulas say.
