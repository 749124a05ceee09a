// The diagrams of chapter 08 show what its formulas say.
