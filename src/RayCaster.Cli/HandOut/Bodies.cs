using System.Text.RegularExpressions;

namespace RayCaster.Cli;

/// <summary>
/// A source file of the lab with marked bodies. Students write the code between <c>// BEGIN SOLUTION "slide"</c> and <c>// END SOLUTION</c>. Lines
/// <c>// STUB code</c> between them are the code before that; without such lines it is a call of <c>Todo.Note</c>.
/// </summary>
/// <param name="lines">The lines, without line ends.</param>
internal sealed partial class Bodies(string[] lines, IReadOnlyList<Bodies.Body> all)
{
    /// <summary>A marked body, with the indexes of its markers' lines.</summary>
    public sealed record Body(string Slide, int Begin, int End);

    private const string StubMarker = "// STUB ";

    public IReadOnlyList<Body> All => all;

    /// <exception cref="ProblemException">A marker is missing, or its slide belongs to no step.</exception>
    public static Bodies Parse(string file, string text)
    {
        var lines = text.Split('\n');
        var all = new List<Body>();
        (string Slide, int Line)? open = null;
        for (var i = 0; i < lines.Length; i++)
        {
            var line = lines[i].Trim();
            if (line.StartsWith("// BEGIN SOLUTION"))
            {
                if (open is var (_, before)) throw Problem(i, $"a body begins here, but that of line {before + 1} has no // END SOLUTION");
                if (BeginMarker().Match(line) is not { Success: true } match)
                    throw Problem(i, "after // BEGIN SOLUTION stands the slide's title in quotes");
                var slide = match.Groups[1].Value;
                if (LabSteps.StepOf(slide) == 0) throw Problem(i, $"no step has the slide \"{slide}\"");
                open = (slide, i);
            }
            else if (line == "// END SOLUTION")
            {
                if (open is not var (slide, begin)) throw Problem(i, "a body ends here that has no // BEGIN SOLUTION");
                all.Add(new(slide, begin, i));
                open = null;
            }
            else if (line.StartsWith("// STUB") && open is null)
            {
                throw Problem(i, "a stub stands between // BEGIN SOLUTION and // END SOLUTION");
            }
        }
        return open is var (_, last) ? throw Problem(last, "the body that begins here has no // END SOLUTION") : new(lines, all);

        ProblemException Problem(int line, string message) => new($"{file}({line + 1}): error: {message}");
    }

    /// <summary>The file with stubs in place of some bodies.</summary>
    /// <param name="isOpen">Whether students write the bodies of a slide. Only these bodies keep their markers.</param>
    public string With(Func<string, bool> isOpen)
    {
        var result = new List<string>();
        var next = 0;
        foreach (var body in All)
        {
            result.AddRange(lines[next..body.Begin]);
            result.AddRange(isOpen(body.Slide)
                ? [lines[body.Begin], .. Stub(body), lines[body.End]]
                : Inside(body).Where(line => !line.Contains(StubMarker)));
            next = body.End + 1;
        }
        result.AddRange(lines[next..]);
        return string.Join('\n', result);
    }

    private string[] Inside(Body body) => lines[(body.Begin + 1)..body.End];

    private List<string> Stub(Body body)
    {
        var stub = Inside(body).Where(line => line.Contains(StubMarker)).Select(line => line.Replace(StubMarker, "")).ToList();
        var indent = lines[body.Begin][..lines[body.Begin].IndexOf('/')];
        return stub.Count > 0 ? stub : [$"{indent}Todo.Note(\"{body.Slide}\");"];
    }

    [GeneratedRegex("^// BEGIN SOLUTION \"([^\"]+)\"$")]
    private static partial Regex BeginMarker();
}
