namespace RayCaster.Teaching.Changes;

/// <summary>A slip that people make in formulas: a paragraph of Slips.txt.</summary>
/// <param name="cost">Orders slips that draw the same: the less, the likelier.</param>
/// <param name="question">What students are asked about it. It never says what the slip is.</param>
/// <param name="answer">What is told at last, with MEANT and WRITTEN for the two expressions.</param>
internal sealed class MutationOperator(string name, double cost, string question, string answer, bool isOfSize)
{
    public double Cost => cost;

    public string Question => question;

    /// <summary>Whether it only makes something larger or smaller.</summary>
    public bool IsOfSize => isOfSize;

    /// <summary>What was written instead of what, in words.</summary>
    public string Tell(string meant, string written) =>
        answer.Replace("MEANT", meant, StringComparison.Ordinal).Replace("WRITTEN", written, StringComparison.Ordinal);

    /// <summary>Its name in the text.</summary>
    public override string ToString() => name;
}
