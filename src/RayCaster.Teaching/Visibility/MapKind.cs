namespace RayCaster.Teaching.Visibility;

/// <summary>The kinds of numbers that a map can have.</summary>
public enum MapKind
{
    /// <summary>The ray parameter of the nearest hit: its distance from the camera.</summary>
    T,

    /// <summary>z = t · (−d·W), the distance along the view direction, for either clip mode.</summary>
    Depth,

    /// <summary>The model's index in the scene file, from 0.</summary>
    Model,
}

/// <summary>Names of maps.</summary>
public static class MapKinds
{
    /// <summary>The names on the command line and in file names.</summary>
    public static readonly string[] Names = [.. Enum.GetNames<MapKind>().Select(name => name.ToLowerInvariant())];

    /// <summary>The kind with a name; null if there is none.</summary>
    public static MapKind? Named(string name) => Array.IndexOf(Names, name) is >= 0 and var index ? (MapKind)index : null;

    /// <summary>The name of a kind.</summary>
    public static string Name(this MapKind kind) => Names[(int)kind];
}
