namespace RayCaster.Teaching.Changes;

/// <summary>How a small edit changes a formula.</summary>
internal enum MutationOperator
{
    Sign,
    LeftOut,
    Swapped,
    OtherName,
    OtherOperation,
    Brackets,
    OtherFunction,
    OtherComponent,
    Constant,
    Root,
    Square,
    Normalized,
    Halved,
    Doubled,
    Absolute,
    Truncated,
    Shifted,
    Turned,
    Strictness,
    AndOr,
    MissingCondition,
    ExtraCondition,
    MinMax,
    OneCrossing,
    OtherLaw,
}

/// <summary>How likely people make an edit, and what to ask them about it.</summary>
internal static class MutationOperators
{
    /// <summary>The cost orders edits that draw the same: the less, the likelier. The question never says what the edit is.</summary>
    private static readonly Dictionary<MutationOperator, (double Cost, string Question)> table = new()
    {
        [MutationOperator.Sign] = (1, "Which way does each part point, and is it added or taken away?"),
        [MutationOperator.LeftOut] = (0.9, "Is each part of the slide's formula there, and in which unit is it?"),
        [MutationOperator.Swapped] = (1, "Does the order of the operands matter, and is it the slide's?"),
        [MutationOperator.OtherName] = (1, "Is each name in it the one that the slide means?"),
        [MutationOperator.OtherOperation] = (1.3, "In which unit is the result? Which operation gives that?"),
        [MutationOperator.Brackets] = (1, "Which parts belong together, and which brackets say so?"),
        [MutationOperator.OtherFunction] = (1.4, "Which side of the triangle is known, and which one is sought?"),
        [MutationOperator.OtherComponent] = (1.1, "Which coordinates belong together?"),
        [MutationOperator.Constant] = (1.2, "What does each number in it stand for?"),
        [MutationOperator.Root] = (1.4, "In which unit is each part: a length, or a length squared?"),
        [MutationOperator.Square] = (1.4, "In which unit is each part: a length, or a length squared?"),
        [MutationOperator.Normalized] = (1.4, "How long must each vector in it be?"),
        [MutationOperator.Halved] = (1.3, "Is it meant whole, or its half?"),
        [MutationOperator.Doubled] = (1.3, "Is it meant once, or twice?"),
        [MutationOperator.Absolute] = (1.8, "May it be negative, and what happens then?"),
        [MutationOperator.Truncated] = (1.3, "Where does a number lose its fraction?"),
        [MutationOperator.Shifted] = (1.2, "From where to where does it count?"),
        [MutationOperator.Turned] = (1, "Which side of the comparison counts?"),
        [MutationOperator.Strictness] = (1.2, "What about the border itself?"),
        [MutationOperator.AndOr] = (1.3, "Must all of its conditions hold, or one?"),
        [MutationOperator.MissingCondition] = (1, "Is every condition of the slide there?"),
        [MutationOperator.ExtraCondition] = (1.5, "Do you test a condition that the slide does not have?"),
        [MutationOperator.MinMax] = (1, "Is the least of them meant, or the greatest?"),
        [MutationOperator.OneCrossing] = (1, "Which crossings are there, and which of them comes first?"),
        [MutationOperator.OtherLaw] = (1.4, "What does it measure, and from where?"),
    };

    public static double CostOf(MutationOperator op) => table[op].Cost;

    public static string QuestionOf(MutationOperator op) => table[op].Question;
}
