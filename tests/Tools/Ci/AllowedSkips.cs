using System.Text.RegularExpressions;

namespace RayCaster.Ci;

/// <summary>tests/allowed-skips.txt: what may be skipped, and on which machines.</summary>
/// <param name="lines">Its lines: a condition, two blanks or more, and a pattern of "JOB: TEST: REASON".</param>
/// <param name="holds">Whether a condition for bash holds here. The pattern's first group is its <c>$1</c>.</param>
internal sealed class AllowedSkips(IEnumerable<string> lines, Func<string, string, bool> holds)
{
    private readonly (string Condition, Regex Pattern)[] rows = [.. lines.Where(line => line.Trim() != "" && !line.StartsWith('#')).Select(line =>
        Regex.Split(line.Trim(), " {2,}") is [var condition, var pattern] ? (condition, new Regex(pattern))
            : throw new InvalidDataException($"tests/allowed-skips.txt: not a condition, two blanks and a pattern: {line}"))];

    /// <summary>The condition of what is always skipped on this system.</summary>
    public const string Always = "always";

    /// <summary>Whether something may be skipped.</summary>
    /// <param name="what">"JOB: TEST: REASON".</param>
    /// <param name="all">Whether this machine must run all that its system can.</param>
    public bool Allow(string what, bool all) => rows.Any(row => row.Pattern.Match(what) is { Success: true } match
        && (row.Condition == Always || !all && holds(row.Condition, match.Groups[1].Value)));
}
