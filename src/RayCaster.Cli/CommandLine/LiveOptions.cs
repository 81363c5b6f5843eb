namespace RayCaster.Cli;

/// <summary>The options of the live page: the command reads them, and then the page's own program, to which it passes them on.</summary>
internal static class LiveOptions
{
    public static readonly Option<string> Mine = Option.Text("--mine", "<file>",
        "Compares with a picture (PNG or PPM) of your own program, each time that your program writes it.");
    public static readonly Option<int?> Port = Option.Count("--port", "The page's port, 1 to 65535. [default: any that is free]", 65535);
    public static readonly Option<bool> NoBrowser = Option.Switch("--no-browser", "Prints the address and opens no browser.");

    /// <summary>Of the page's program alone: the command adds it.</summary>
    public static readonly Option<bool> UntilInputEnds = Option.Switch("--until-input-ends", "Ends when its standard input is closed.");

    /// <summary>Also of the page's program alone, for its tests.</summary>
    public static readonly Option<int?> Silence = Option.Count("--silence", "How many seconds a browser may be silent. [default: 20]", 3600);

    public static readonly Option[] All = [Mine, Port, NoBrowser];
}
