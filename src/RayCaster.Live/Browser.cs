namespace RayCaster.Live;

/// <summary>Opens the page in the user's browser.</summary>
internal static class Browser
{
    public static bool HasScreen => OperatingSystem.IsWindows() || OperatingSystem.IsMacOS()
        || Environment.GetEnvironmentVariable("DISPLAY") is { Length: > 0 }
        || Environment.GetEnvironmentVariable("WAYLAND_DISPLAY") is { Length: > 0 };

    /// <summary>
    /// Opens an address. Other users can read the arguments of a program (not on Windows), so the browser gets a private file that leads to the
    /// address. It is in the home folder, under a plain name: some browsers may read neither hidden folders nor those for temporary files.
    /// </summary>
    /// <param name="end">When it completes, the file is deleted.</param>
    public static async Task OpenAsync(string address, int port, Task end)
    {
        try
        {
            if (OperatingSystem.IsWindows())
            {
                Programs.Open(address);
                return;
            }
            var file = PrivateFile.PathOf(Environment.SpecialFolder.UserProfile, $"raycaster-live-{port}.html");
            PrivateFile.Write(file, $"""<!doctype html><meta http-equiv="refresh" content="0; url={address}">""");
            try
            {
                Programs.Open(file);
                await end;
            }
            finally
            {
                File.Delete(file);
            }
        }
        catch (Exception e) when (e is ProblemException || ProblemException.IsCausedByFile(e))
        {
            // No program that opens files, or no home folder: the address is on the terminal.
        }
    }
}
