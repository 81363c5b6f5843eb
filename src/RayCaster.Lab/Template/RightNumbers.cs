using System.Diagnostics;
using System.Reflection;

namespace Lab;

/// <summary>The program's part that knows the right numbers of a pixel. You need not read this.</summary>
/// <remarks>It is loaded when --pixel asks for it, not referenced: an edit of the lab need not wait until it is built.</remarks>
public static class RightNumbers
{
    private const string Teaching = "RayCaster.Teaching";

    /// <summary>Prints what your methods compute for a pixel, beside the right numbers; returns the program's exit code.</summary>
    /// <param name="pixel">What follows --pixel.</param>
    public static int PrintBeside(RayCaster.Scene from, string[] pixel)
    {
        if (Load() is not { } teaching) return 2;
        Todo.Listen();
        return teaching.GetType("RayCaster.Teaching.Course.PixelNumbers").GetMethod("Print")
            .CreateDelegate<Func<RayCaster.Scene, string[], Func<int, int, IEnumerable<(string, Func<object>)>>, Func<IEnumerable<string>>, int>>()(
                from, pixel, (c, r) => Pixel.Calls(from, c, r), () => Todo.NotWritten);
    }

    /// <summary>A hand-out has it beside this program. In a clone it is built; null if that fails.</summary>
    private static Assembly Load()
    {
        var beside = Path.Combine(AppContext.BaseDirectory, $"{Teaching}.dll");
        if (File.Exists(beside)) return Assembly.LoadFrom(beside);

        var project = Repository.PathOf($"src/{Teaching}");
        using var build = Process.Start(new ProcessStartInfo("dotnet", ["build", project, "-v", "quiet", "-tl:off", "-c", "Release"])
        {
            RedirectStandardOutput = true, // even quietly it says that it has succeeded
        });
        var said = build.StandardOutput.ReadToEnd();
        build.WaitForExit();
        if (build.ExitCode == 0) return Assembly.LoadFrom(Path.Combine(project, "bin", "Release", "net10.0", $"{Teaching}.dll"));
        Console.Error.WriteLine($"The right numbers are not there, because {project} does not build:\n{said.Trim()}");
        return null;
    }
}
