// The diagrams of chapter 04 show what its formulas say.
