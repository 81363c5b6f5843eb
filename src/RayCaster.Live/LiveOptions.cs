using System.Globalization;

namespace RayCaster.Live;

/// <param name="Mine">The file of a picture by the user's own program to compare with; null for none.</param>
/// <param name="Port">The page's port; 0 for any that is free.</param>
/// <param name="EndsWithInput">Whether the program ends as soon as its standard input is closed: when the program that started it has ended.</param>
internal sealed record LiveOptions(string Scene, string? Mine, int Port, bool OpensBrowser, bool EndsWithInput = false)
{
    /// <summary>What a command line asks for; null for the help.</summary>
    public static LiveOptions? Parse(string[] arguments)
    {
        var (scene, mine, port, opens, ends) = (default(string), default(string), 0, true, false);
        arguments = [.. arguments.SelectMany(word => word.StartsWith("--", StringComparison.Ordinal) ? word.Split('=', 2) : [word])];
        for (var i = 0; i < arguments.Length; i++)
        {
            switch (arguments[i])
            {
                case "--help" or "-?" or "-h" or "help":
                    return null;
                case "--no-browser":
                    opens = false;
                    break;
                case "--until-input-ends":
                    ends = true;
                    break;
                case "--mine":
                    mine = Value(arguments, ref i);
                    break;
                case "--port":
                    port = PortOf(Value(arguments, ref i));
                    break;
                case ['-', _, ..] unknown:
                    string[] options = ["--mine", "--port", "--no-browser", "--help"];
                    throw ProblemException.Usage($"there is no option '{unknown}'{Spelling.DidYouMean(unknown, options, quote: '\'')}");
                case var operand when scene is null:
                    scene = operand;
                    break;
                case var operand:
                    throw ProblemException.Usage($"one scene at a time, but there are two: {scene}, {operand}");
            }
        }
        if (scene is null) throw ProblemException.Usage("no scene is given: name a scene file, for example scenes/first.json");
        return new(scene, mine, port, opens, ends);
    }

    private static string Value(string[] arguments, ref int i) =>
        ++i < arguments.Length ? arguments[i] : throw ProblemException.Usage($"option '{arguments[i - 1]}' needs a value after it");

    private static int PortOf(string text) =>
        int.TryParse(text, NumberStyles.None, CultureInfo.InvariantCulture, out var port) && port is > 0 and <= 65535
            ? port
            : throw ProblemException.Usage($"'{text}' is not a port; a port is a whole number from 1 to 65535");
}
