namespace RayCaster;

/// <summary>What a token of a JSON text is.</summary>
internal enum JsonKind
{
    /// <summary>Nothing: before the first token.</summary>
    None,

    /// <summary>A brace opens.</summary>
    Object,

    /// <summary>A bracket opens.</summary>
    Array,

    /// <summary>What was opened last is closed; a tree does not hold this.</summary>
    End,

    /// <summary>A key of an object; its value follows.</summary>
    Key,

    /// <summary>A text in quotes.</summary>
    Text,

    /// <summary>A number.</summary>
    Number,

    /// <summary>true, false or null.</summary>
    Literal,
}
