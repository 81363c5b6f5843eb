namespace RayCaster.Files;

/// <summary>Writes a camera's position and target into the text of a scene. Only numbers that differ change; comments and layout stay.</summary>
internal static class CameraEdit
{
    /// <param name="utf8">The text of a scene without errors, with or without a byte order mark.</param>
    public static byte[] Write(ReadOnlyMemory<byte> utf8, Camera camera)
    {
        var tree = JsonTree.Parse(new("", utf8, ""))!;
        var written = tree.Root.Find("camera")!.Value;
        var edits = new List<(JsonValue, string)>();
        Replace("position", camera.Position);
        Replace("target", camera.Target);
        return tree.With(edits);

        void Replace(string key, Vector3 v)
        {
            foreach (var (value, number) in written.Find(key)!.Value.Content.Zip((double[])[v.X, v.Y, v.Z]))
                if (value.Number != number)
                    edits.Add((value, number.ToString("R", CultureInfo.InvariantCulture)));
        }
    }
}
