using System.Runtime.CompilerServices;

namespace RayCaster.Testing;

/// <summary>Tests leave the user's own data alone: what programs keep there is in a folder for temporary files.</summary>
internal static class OwnDataFolder
{
    [ModuleInitializer]
    internal static void Set() => Environment.SetEnvironmentVariable("XDG_DATA_HOME", Path.Combine(Path.GetTempPath(), "raycaster-tests-data"));
}
