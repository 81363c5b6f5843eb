using System.Diagnostics;
using Lab;
using RayCaster.Files;

// Reads the command line. You need not read this.

Console.OutputEncoding = System.Text.Encoding.UTF8; // of a console of Windows; others have it already
if (args.Length == 0 && PathResolver.FolderWith("scenes/room.json") is { } folder)
    args = [Path.Combine(folder, "scenes/room.json"), Path.Combine(folder, "room.png")]; // as F5 in an editor does
if (args is [var scene]) args = [scene, Path.ChangeExtension(Path.GetFileName(scene), "png")]; // room.png, in this folder
if (args is not ([_, _] or [_, "--pixel", ..]))
{
    Console.Error.WriteLine("Draws a scene, for example: scenes/room.json, which writes room.png, or: scenes/room.json other.png\n" +
        "Or shows your numbers for one pixel, here in column 325 and line 359 from the top: scenes/room.json --pixel 325 359");
    return 2;
}
var reading = SceneReader.Read(args[0]);
Console.Error.Write(reading.Report()); // what is wrong with the file, with line and column
if (reading.Scene == null) return 2;
try
{
    if (args is [_, "--pixel", .. var pixel]) return RightNumbers.PrintBeside(reading.Scene, pixel);
    var notWritten = Todo.Report();
    if (notWritten != "") Console.Error.WriteLine(notWritten);
    var picture = SceneFile.Of(reading.Scene).Draw();
    PictureFile.Write(args[1], picture);
    Console.WriteLine($"{args[1]}: {picture.Width} x {picture.Height} pixels");
    return 0;
}
catch (ProblemException problem) // a name that no file can have, a folder that does not exist, a full disk, no dotnet
{
    Console.Error.WriteLine(problem.Message);
    return 2;
}
catch (Exception mistake) // in the student's code
{
    var place = new StackTrace(mistake, fNeedFileInfo: true).GetFrames().FirstOrDefault(frame => frame.GetFileLineNumber() > 0);
    Console.Error.WriteLine($"{place?.GetFileName()}({place?.GetFileLineNumber()}): {mistake.GetType().Name}: {mistake.Message}");
    return 1;
}
