using System.Reflection;
using RayCaster.Files;

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
        Todo.Listen();
        return Load().GetType("RayCaster.Teaching.Course.PixelNumbers").GetMethod("Print")
            .CreateDelegate<Func<RayCaster.Scene, string[], Func<int, int, IEnumerable<(string, Func<object>)>>, Func<IEnumerable<string>>, int>>()(
                from, pixel, (c, r) => Pixel.Calls(from, c, r), () => Todo.NotWritten);
    }

    // A hand-out has it beside this program. In a clone it is built.
    private static Assembly Load()
    {
        var folder = AppContext.BaseDirectory;
        if (!File.Exists(Path.Combine(folder, $"{Teaching}.dll")) && PathResolver.FolderWith("RayCaster.sln") is { } clone)
            folder = Programs.Build(Path.Combine(clone, "src", Teaching));
        return Assembly.LoadFrom(Path.Combine(folder, $"{Teaching}.dll"));
    }
}
