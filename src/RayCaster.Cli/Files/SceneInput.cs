using System.Runtime.CompilerServices;

namespace RayCaster.Cli;

internal static class SceneInput
{
    public static string NameOf(string scene) => scene == StandardStreams.Name ? "scene" : Path.GetFileNameWithoutExtension(scene);

    /// <summary>Reads a scene and prints its errors and warnings.</summary>
    /// <param name="path">The file, or "-".</param>
    /// <inheritdoc cref="TryRead"/>
    public static Scene Read(string path, CommandLine line, bool warns = true, bool judges = false)
    {
        var reading = TryRead(path, line, judges);
        if (reading.Scene is null || (warns && !line.Get(Option.Quiet))) StandardStreams.WriteError(reading.Report());
        var scene = reading.Scene ?? throw new ReportedException($"{path} has errors");
        return line.Get(Option.Size) is var (width, height) ? scene.WithSize(width, height) : scene;
    }

    /// <param name="judges">Whether the command judges pictures by this scene: warns if this build's picture of it differs from the stored
    /// reference.</param>
    public static SceneReading TryRead(string path, CommandLine line, bool judges)
    {
        var reading = path == StandardStreams.Name ? ReadStandardInput() : SceneReader.Read(path);
        OutputFile.Protect((string[])[path, .. reading.MeshFiles]); // no list that is compiled for it
        if (judges && path != StandardStreams.Name && reading.Scene is { } scene) WarnIfChanged(path, scene, line);
        return reading;
    }

    /// <summary>A method of its own, because the runtime loads RayCaster.Teaching when it compiles one that uses it.</summary>
    [MethodImpl(MethodImplOptions.NoInlining)]
    private static void WarnIfChanged(string path, Scene scene, CommandLine line)
    {
        if (StoredReference.Contradiction(path, scene) is { } message) line.Warn($"{message}. What follows may be wrong.");
    }

    private static SceneReading ReadStandardInput()
    {
        using var input = Console.OpenStandardInput();
        return SceneReader.Read(input, "<stdin>", Environment.CurrentDirectory);
    }
}
