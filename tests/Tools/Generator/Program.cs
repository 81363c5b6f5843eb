// Writes the files that are made from the code: schemas, meshes, an explanation, and the gallery of mistakes. Prints the name of each file
// that was out of date. With --check it writes nothing, and the exit code is 1 if there was one.
using RayCaster;
using RayCaster.Generator;
using RayCaster.Files.Tests.Meshes;
using RayCaster.Files.Tests.Scenes;
using RayCaster.Teaching.Tests.Marks;
using RayCaster.Teaching.Tests.Explanations;
using RayCaster.Teaching.Tests.Mistakes;

if (args is not ([] or ["--check"]))
{
    Console.Error.WriteLine("dotnet run --project tests/Tools/Generator [-- --check]");
    return 2;
}
var (check, old) = (args.Length > 0, 0);
Text(SceneSchema.File, SceneSchema.Write());
Text(RubricSchema.File, RubricSchema.Write());
Text(PixelExplanationTests.TextFile, PixelExplanationTests.Text());
foreach (string name in CommittedMeshesTests.Names)
    Write(CommittedMeshesTests.PathOf(name), CommittedMeshesTests.Make(name), File.ReadAllBytes(CommittedMeshesTests.PathOf(name)).SequenceEqual);
Text(Gallery.File, Gallery.Page());
foreach (var mistake in MistakeCatalog.All)
    Drawing(Gallery.PictureOf(mistake), Showcase.Of(mistake).Draw(mistake), mistake.Id == "tri-area" ? 0.1 : 0.01);
Drawing(Gallery.SheetFile, Gallery.Sheet(), 0.01);
return check && old > 0 ? 1 : 0;

void Text(string file, string text) =>
    Write(file, System.Text.Encoding.UTF8.GetBytes(text), was => System.Text.Encoding.UTF8.GetString(was).ReplaceLineEndings("\n") == text);

// The pixels are compared, not the files. A few may be turned by the last bits of another machine's tangent; of lace, more.
void Drawing(string file, Picture picture, double most) => Write(file, Png(picture), bytes =>
    PictureFile.Read(new MemoryStream(bytes)) is var was && (was.Width, was.Height) == (picture.Width, picture.Height)
    && ChangedPixels.Count(was, picture, levels: 2) <= most * picture.Width * picture.Height);

byte[] Png(Picture picture)
{
    var stream = new MemoryStream();
    PictureFile.Write(stream, picture, PictureFormat.Png);
    return stream.ToArray();
}

void Write(string file, byte[] content, Func<byte[], bool> isUpToDate)
{
    if (File.Exists(file) && isUpToDate(File.ReadAllBytes(file))) return;
    if (!check) File.WriteAllBytes(file, content);
    Console.WriteLine((check ? "old: " : "written: ") + Path.GetRelativePath(ProjectFolder.Root, file));
    old++;
}
