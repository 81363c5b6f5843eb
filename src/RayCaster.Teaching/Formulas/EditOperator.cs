namespace RayCaster.Teaching;

/// <summary>How a small edit changes a formula.</summary>
internal enum EditOperator
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
internal static class EditOperators
{
    /// <summary>The cost orders edits that draw the same: the less, the likelier. The question never says what the edit is.</summary>
    private static readonly Dictionary<EditOperator, (double Cost, string Question)> table = new()
    {
        [EditOperator.Sign] = (1, "Which way does each part point, and is it added or taken away?"),
        [EditOperator.LeftOut] = (0.9, "Is each part of the slide's formula there, and in which unit is it?"),
        [EditOperator.Swapped] = (1, "Does the order of the operands matter, and is it the slide's?"),
        [EditOperator.OtherName] = (1, "Is each name in it the one that the slide means?"),
        [EditOperator.OtherOperation] = (1.3, "In which unit is the result? Which operation gives that?"),
        [EditOperator.Brackets] = (1, "Which parts belong together, and which brackets say so?"),
        [EditOperator.OtherFunction] = (1.4, "Which side of the triangle is known, and which one is sought?"),
        [EditOperator.OtherComponent] = (1.1, "Which coordinates belong together?"),
        [EditOperator.Constant] = (1.2, "What does each number in it stand for?"),
        [EditOperator.Root] = (1.4, "In which unit is each part: a length, or a length squared?"),
        [EditOperator.Square] = (1.4, "In which unit is each part: a length, or a length squared?"),
        [EditOperator.Normalized] = (1.4, "How long must each vector in it be?"),
        [EditOperator.Halved] = (1.3, "Is it meant whole, or its half?"),
        [EditOperator.Doubled] = (1.3, "Is it meant once, or twice?"),
        [EditOperator.Absolute] = (1.8, "May it be negative, and what happens then?"),
        [EditOperator.Truncated] = (1.3, "Where is a number cut to a whole one, or fixed?"),
        [EditOperator.Shifted] = (1.2, "From where to where does it count?"),
        [EditOperator.Turned] = (1, "Which side of the comparison counts?"),
        [EditOperator.Strictness] = (1.2, "What about the border itself?"),
        [EditOperator.AndOr] = (1.3, "Must all of its conditions hold, or one?"),
        [EditOperator.MissingCondition] = (1, "Is every condition of the slide there?"),
        [EditOperator.ExtraCondition] = (1.5, "Does the slide ask for so much?"),
        [EditOperator.MinMax] = (1, "Is the least of them meant, or the greatest?"),
        [EditOperator.OneCrossing] = (1, "Which crossings are there, and which of them comes first?"),
        [EditOperator.OtherLaw] = (1.4, "What does it measure, and from where?"),
    };

    public static double CostOf(EditOperator op) => table[op].Cost;

    public static string QuestionOf(EditOperator op) => table[op].Question;
}
