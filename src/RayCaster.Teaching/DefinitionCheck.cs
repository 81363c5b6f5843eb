using System.Runtime.ExceptionServices;

namespace RayCaster.Teaching;

/// <summary>Compares some hundred pixels of a picture with the definition's (<see cref="ScalarRenderer"/>): windows of two by two pixels in the
/// corners, on models and at random places. The definition is computed on a thread of its own while the picture is drawn.</summary>
public sealed class DefinitionCheck
{
    private const int Side = 2, MostModels = 32, RandomWindows = 24;

    /// <summary>A window of a mesh of a million triangles takes four million crossings, so of large scenes fewer windows are compared.</summary>
    private const long MostCrossings = 4_000_000;

    private readonly Scene scene;
    private readonly int firstLine, width, height; // of the lines that are drawn
    private readonly List<Window> windows = [];
    private readonly Thread definition;
    private Exception? failure;
    private int linesTaken;

    /// <summary>Chooses the windows and begins to compute the definition.</summary>
    /// <param name="lines">Which lines, counted from the top.</param>
    public DefinitionCheck(Scene scene, Range lines)
    {
        this.scene = scene;
        (firstLine, height) = lines.GetOffsetAndLength(scene.Camera.Height);
        width = scene.Camera.Width;
        Choose();
        definition = new Thread(Compute) { IsBackground = true, Name = "definition" };
        definition.Start();
    }

    /// <summary>Draws the fast way. If that fails, and the definition, too, the exception is the definition's: its stack names the class whose
    /// formula fails, which the engine's code has inlined.</summary>
    public void Watch(Action draw)
    {
        try
        {
            draw();
        }
        catch (Exception e) when (e is not OperationCanceledException && Failure is { } fault)
        {
            ExceptionDispatchInfo.Throw(fault);
        }
    }

    /// <summary>Takes the next lines that were drawn.</summary>
    /// <param name="rgb">Whole lines, three bytes a pixel.</param>
    public void Take(ReadOnlySpan<byte> rgb)
    {
        for (; rgb.Length > 0; rgb = rgb[(3 * width)..], linesTaken++)
            foreach (var window in windows)
                if (linesTaken >= window.Line && linesTaken < window.Line + window.Drawn.Height)
                    rgb.Slice(3 * window.Column, 3 * window.Drawn.Width)
                        .CopyTo(window.Drawn.Rgb.AsSpan((linesTaken - window.Line) * 3 * window.Drawn.Width));
    }

    /// <summary>The first pixel that differs, once all lines are taken, as a message; null where all are equal.</summary>
    public string? FirstDifference()
    {
        if (Failure is { } fault) return $"the definition cannot be compared: {fault.Message}";
        foreach (var window in windows)
        {
            for (var i = 0; i < window.Drawn.Rgb.Length; i += 3)
            {
                var fast = window.Drawn.Rgb.AsSpan(i, 3);
                var right = window.Right.Rgb.AsSpan(i, 3);
                if (fast.SequenceEqual(right)) continue;
                var (y, x) = Math.DivRem(i / 3, window.Drawn.Width);
                return $"column {window.Column + x}, line {firstLine + window.Line + y}: the fast way gives ({fast[0]}, {fast[1]}, {fast[2]}), " +
                    $"ScalarRenderer ({right[0]}, {right[1]}, {right[2]})";
            }
        }
        return null;
    }

    private Exception? Failure
    {
        get
        {
            definition.Join();
            return failure;
        }
    }

    private void Compute()
    {
        try
        {
            foreach (var window in windows) ScalarRenderer.Render(scene, window.Right, window.Column, firstLine + window.Line);
        }
        catch (Exception e) // of a change that throws; the picture is then drawn by the definition, which shows it
        {
            failure = e;
        }
    }

    private void Choose()
    {
        var most = (int)Math.Max(1, MostCrossings / Math.Max(1, scene.ShapeCount) / (Side * Side));
        Add(0, 0);
        Add(width, 0);
        Add(0, height);
        Add(width, height);
        var camera = scene.Camera;
        foreach (var model in scene.Models.Take(MostModels))
            if (model.Bounds is { } bounds && Tile.Of(bounds.PaddedFrom(camera.Position), camera) is { Area: > 0 } seen)
                Add(seen.Column + Math.Min(seen.Width, width) / 2, // a tile around the camera reaches beyond the picture
                    camera.Height - 1 - (seen.Row + Math.Min(seen.Height, camera.Height) / 2) - firstLine);
        var random = new Random(1); // the same windows in each run
        for (var i = 0; i < RandomWindows; i++) Add(random.Next(width), random.Next(height));
        if (windows.Count > most) windows.RemoveRange(most, windows.Count - most);
    }

    /// <summary>Adds a window, moved to where it lies within the picture.</summary>
    private void Add(int column, int line)
    {
        var (across, down) = (Math.Min(Side, width), Math.Min(Side, height));
        windows.Add(new(Math.Clamp(column, 0, width - across), Math.Clamp(line, 0, height - down), new(across, down), new(across, down)));
    }

    /// <param name="Line">The first line of those that are drawn.</param>
    /// <param name="Drawn">What the fast way gives.</param>
    private readonly record struct Window(int Column, int Line, Picture Drawn, Picture Right);
}
