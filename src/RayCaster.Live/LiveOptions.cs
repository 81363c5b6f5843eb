using System.Globalization;

namespace RayCaster.Live;

/// <summary>The command line, understood.</summary>
/// <param name="Scene">The scene file.</param>
/// <param name="Mine">A picture of the user's own program to compare with; null for none.</param>
/// <param name="Port">Where the page is; 0 for any port that is free.</param>
/// <param name="OpensBrowser">Whether a browser is opened.</param>
/// <param name="WantsHelp">Whether only the help is wanted.</param>
internal sealed record LiveOptions(string Scene, string? Mine, int Port, bool OpensBrowser, bool WantsHelp = false)
{
    public const string Help = """
        Description:
          Opens a page on this machine that shows a scene's picture and stays in step with the
          scene file: save, and see it. Drag to turn the camera, click a pixel and read why.

        Usage:
          dotnet run --project src/RayCaster.Live -- <scene> [options]

        Options:
              --mine <file>  A picture (PNG or PPM) of your own program to compare with; when it
                             is written again, the page follows.
              --port <n>     Where the page is, 1 to 65535. [default: any that is free]
              --no-browser   Only prints the address, and opens no browser.
          -?, --help         Shows this help. Under "dotnet run" write it after "--".

        Exit codes:
          2 could not do it, 130 interrupted (Ctrl-C), 143 terminated.

        """;

    /// <exception cref="ProblemException">The command line cannot be understood.</exception>
    public static LiveOptions Parse(string[] arguments)
    {
        var (scene, mine, port, opens) = (default(string), default(string), 0, true);
        for (var i = 0; i < arguments.Length; i++)
        {
            switch (arguments[i])
            {
                case "--help" or "-?" or "-h" or "help":
                    return new("", null, 0, false, WantsHelp: true);
                case "--no-browser":
                    opens = false;
                    break;
                case "--mine":
                    mine = Value(arguments, ref i);
                    break;
                case "--port":
                    port = PortOf(Value(arguments, ref i));
                    break;
                case ['-', _, ..] unknown:
                    throw ProblemException.Usage($"there is no option '{unknown}'");
                case var operand when scene is null:
                    scene = operand;
                    break;
                case var operand:
                    throw ProblemException.Usage($"one scene at a time, but there are two: {scene}, {operand}");
            }
        }
        return new(scene ?? throw ProblemException.Usage("which scene? Name a scene file, for example scenes/first.json"), mine, port, opens);
    }

    private static string Value(string[] arguments, ref int i) =>
        ++i < arguments.Length ? arguments[i] : throw ProblemException.Usage($"option '{arguments[i - 1]}' needs a value after it");

    private static int PortOf(string text) =>
        int.TryParse(text, NumberStyles.None, CultureInfo.InvariantCulture, out var port) && port is > 0 and <= 65535
            ? port
            : throw ProblemException.Usage($"'{text}' is not a port: it is a whole number from 1 to 65535");
}

/// <summary>Something that the user can mend; the message is all that is printed.</summary>
internal sealed class ProblemException(string message) : Exception(message)
{
    /// <summary>A mistake on the command line, with where to look it up.</summary>
    public static ProblemException Usage(string problem) =>
        new($"raycaster-live: {problem}\nTry dotnet run --project src/RayCaster.Live -- --help.");
}
