using System.Text.RegularExpressions;

namespace RayCaster.Cli;

/// <summary>
/// The marked bodies in a source file of the lab. Students write the code between <c>// BEGIN SOLUTION "slide"</c> and <c>// END SOLUTION</c>. Lines
/// <c>// STUB code</c> between them are the code before that; without such lines it is a call of <c>Todo.Note</c>.
/// </summary>
internal static partial class Bodies
{
    private const string Stub = "// STUB ";

    /// <summary>A file with stubs in place of some bodies.</summary>
    /// <param name="file">Its name in messages.</param>
    /// <param name="isOpen">Whether students write the bodies of a step. Only these bodies keep their markers.</param>
    public static string With(string file, string text, Func<int, bool> isOpen)
    {
        var rest = Body().Replace(text, body => Regex.Replace(body.Value, ".+", "")); // with as many lines
        if (Marker().Match(rest) is { Success: true } alone)
            throw new ProblemException($"{file}({rest.AsSpan(0, alone.Index).Count('\n') + 1}): error: " +
                "a body stands between // BEGIN SOLUTION \"slide\" and // END SOLUTION, and with it its // STUB");
        return Body().Replace(text, body =>
        {
            var slide = body.Groups["slide"].Value;
            var code = body.Groups["line"].Captures.Select(line => line.Value);
            var step = Slides.StepOf(slide);
            if (step == 0) throw new ProblemException($"{file}: error: no step has the slide \"{slide}\"");
            if (!isOpen(step)) return string.Concat(code.Where(line => !line.Contains(Stub)));
            var stub = string.Concat(code.Where(line => line.Contains(Stub)).Select(line => line.Replace(Stub, "")));
            if (stub == "") stub = $"{body.Groups["indent"]}Todo.Note(\"{slide}\");\n";
            return $"{body.Groups["begin"]}{stub}{body.Groups["end"]}";
        });
    }

    [GeneratedRegex(@"^(?<begin>(?<indent> *)// BEGIN SOLUTION ""(?<slide>[^""\n]+)""\n)" +
        @"(?<line>(?! *// (BEGIN|END) SOLUTION).*\n)*(?<end> *// END SOLUTION\n)", RegexOptions.Multiline)]
    private static partial Regex Body();

    [GeneratedRegex("// (BEGIN SOLUTION|END SOLUTION|STUB)")]
    private static partial Regex Marker();
}
