using System.Reflection.Metadata;
using System.Reflection.PortableExecutable;

namespace RayCaster.Teaching;

/// <summary>
/// Finds what a submission's compiled program calls of this project's library besides reading scenes and writing pictures: a call of its renderer,
/// rays or shapes is a ray caster that the student did not write. The assemblies are read, not loaded.
/// </summary>
internal static class LibraryCalls
{
    private const long MaxBytes = 1 << 26;

    private static readonly HashSet<string> libraries =
    [
        .. ((Type[])[typeof(ScalarRenderer), typeof(Renderer), typeof(SceneReader), typeof(ClassMarks)]).Select(
            type => type.Assembly.GetName().Name!),
    ];

    /// <summary>Types that read scenes and write pictures. Of others, programs only read properties, in order to copy a scene.</summary>
    private static readonly HashSet<string> allowed =
        [nameof(SceneReader), nameof(SceneReading), nameof(PictureFile), nameof(PictureFormat), nameof(Picture), nameof(ProblemException),
            nameof(PixelNumbers)];

    /// <summary>Calls of the runtime that reach any member, or another program.</summary>
    private static readonly HashSet<string> detours =
        ["MethodBase.Invoke", "Type.InvokeMember", "Assembly.Load", "Assembly.LoadFrom", "Assembly.LoadFile", "Process.Start", "Console.SetOut"];

    /// <summary>The members that the assemblies in a folder call, each with its file; empty if there are none.</summary>
    public static IReadOnlyList<string> In(string folder)
    {
        var calls =
            from file in Submission.State(folder)
            where Path.GetExtension(file.Path).ToLowerInvariant() is ".dll" or ".exe"
            from call in Of(RegularFile.Read(file.Path, MaxBytes) ?? [])
            select (Call: call, File: Path.GetFileName(file.Path));
        return [.. calls.Distinct().Select(call => $"{call.File} calls {call.Call}").Order(StringComparer.Ordinal)];
    }

    private static IReadOnlyList<string> Of(byte[] assembly)
    {
        try
        {
            using var file = new PEReader(ImmutableArray.Create(assembly));
            if (!file.HasMetadata) return [];
            var metadata = file.GetMetadataReader();
            if (!metadata.IsAssembly || libraries.Contains(metadata.GetString(metadata.GetAssemblyDefinition().Name))) return [];
            return [.. metadata.MemberReferences.Select(handle => CallOf(metadata, metadata.GetMemberReference(handle))).OfType<string>()];
        }
        catch (Exception e) when (e is BadImageFormatException or ArgumentException or InvalidOperationException or OverflowException)
        {
            return []; // a program of another kind, or a damaged one
        }
    }

    /// <summary>A member in words if it is one that a student's own program does not need; otherwise null.</summary>
    private static string? CallOf(MetadataReader metadata, MemberReference member)
    {
        if (member.GetKind() != MemberReferenceKind.Method || TypeOf(metadata, member.Parent) is not { } type
            || type.ResolutionScope.Kind != HandleKind.AssemblyReference) return null;
        var assembly = metadata.GetString(metadata.GetAssemblyReference((AssemblyReferenceHandle)type.ResolutionScope).Name);
        var (typeName, name) = (metadata.GetString(type.Name).Split('`')[0], metadata.GetString(member.Name));
        var call = $"{typeName}.{name}";
        if (!libraries.Contains(assembly)) return detours.Contains(call) ? call : null;
        if (allowed.Contains(typeName) || name.StartsWith("get_", StringComparison.Ordinal) || name is "op_Equality" or "op_Inequality") return null;
        return $"{metadata.GetString(type.Namespace)}.{call}";
    }

    /// <summary>The type of a member, also one like <c>Ray&lt;double&gt;</c>; null if it is the program's own.</summary>
    private static TypeReference? TypeOf(MetadataReader metadata, EntityHandle parent)
    {
        if (parent.Kind == HandleKind.TypeSpecification)
        {
            var signature = metadata.GetBlobReader(metadata.GetTypeSpecification((TypeSpecificationHandle)parent).Signature);
            if (signature.ReadSignatureTypeCode() != SignatureTypeCode.GenericTypeInstance) return null;
            signature.ReadCompressedInteger(); // class or struct
            parent = signature.ReadTypeHandle();
        }
        return parent.Kind == HandleKind.TypeReference ? metadata.GetTypeReference((TypeReferenceHandle)parent) : null;
    }
}
