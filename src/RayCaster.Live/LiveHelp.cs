namespace RayCaster.Live;

/// <summary>The help of the live page's program. The console app is compiled with it too, because it starts this program.</summary>
internal static class LiveHelp
{
    public const string Text = """
        Description:
          Opens a page on this machine that shows a scene's picture and draws it again when you
          save the scene file. Drag to turn the camera; click a pixel to read how it got its
          colour.

        Usage:
          raycaster live <scene> [options]
          dotnet run --project src/RayCaster.Live -- <scene> [options]

        Options:
              --mine <file>  Compares with a picture (PNG or PPM) of your own program, each time
                             that your program writes it.
              --port <n>     The page's port, 1 to 65535. [default: any that is free]
              --no-browser   Prints the address and opens no browser.

        Exit codes:
          2 failed, 130 interrupted (Ctrl-C), 143 terminated.
        """;
}
