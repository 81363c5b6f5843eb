using System.Buffers.Binary;
using System.IO.Compression;
using RayCaster.Testing.Fuzzing;

namespace RayCaster.Cli.Tests;

/// <summary>Frames, and what is made of them, as commands.</summary>
public sealed class FrameTests : CommandTests
{
    [Fact]
    public void AnOrbitIsNumberedFramesThatBeginWithTheScenesOwnPicture()
    {
        Directory.CreateDirectory(raycaster.PathOf("film"));
        raycaster.Run(Room, "-s", "20x15", "-o", "room.png").Run("orbit", Room, "--frames", "3", "-s", "20x15", "-o", "film");
        Assert.Matches(@"^film: 3 frames of 20 x 15 pixels drawn, 0 existed already, \d+\.\d\d s\n$", raycaster.Error);
        Assert.Equal(["room-0000.png", "room-0001.png", "room-0002.png"], Frames("film"));
        Assert.Equal(PictureFile.Read(raycaster.PathOf("room.png")).Rgb, PictureFile.Read(raycaster.PathOf("film/room-0000.png")).Rgb);
    }

    [Fact]
    public void FramesOfManyMachinesAreThoseOfOne()
    {
        foreach (var folder in (string[])["one", "many"]) Directory.CreateDirectory(raycaster.PathOf(folder));
        raycaster.Run("orbit", Room, "--frames", "5", "-s", "20x15", "-o", "one");
        foreach (var only in (string[])["2/2", "0..1"]) raycaster.Run("orbit", Room, "--frames", "5", "-s", "20x15", "-o", "many", "--only", only);
        Assert.Equal(Frames("one"), Frames("many"));
        foreach (var frame in Frames("one"))
            Assert.Equal(File.ReadAllBytes(raycaster.PathOf($"one/{frame}")), File.ReadAllBytes(raycaster.PathOf($"many/{frame}")));
    }

    [Fact]
    public void FramesThatAreThereAreLeftOut()
    {
        raycaster.Run("orbit", Room, "--frames", "4", "-s", "20x15");
        File.Delete(raycaster.PathOf("room-0002.png"));
        var before = File.GetLastWriteTimeUtc(raycaster.PathOf("room-0001.png"));
        raycaster.Run("orbit", Room, "--frames", "4", "-s", "20x15", "--resume");
        Assert.StartsWith(".: 1 frame of 20 x 15 pixels drawn, 3 existed already, ", raycaster.Error);
        Assert.Equal(before, File.GetLastWriteTimeUtc(raycaster.PathOf("room-0001.png")));
        raycaster.Run("orbit", Room, "--frames", "5", "-s", "20x15", "--resume"); // another film: only frame 0 is the same
        Assert.StartsWith("room-0001.png is drawn again: it shows another scene, another size or other lines\n" +
            ".: 4 frames of 20 x 15 pixels drawn, 1 existed already, ", raycaster.Error);
    }

    [Fact]
    public void ACameraFollowsItsKeys()
    {
        raycaster.Write("way.json", """{ "keys": [ { "time": 0, "position": [20, 0, 0] }, { "time": 1, "position": [10, 0, 0] } ] }""");
        raycaster.Run("orbit", Room, "--frames", "2", "-s", "20x15", "--keys", "way.json");
        raycaster.Write("near.json", File.ReadAllText(Room).Replace("\"position\": [20, 0, 0]", "\"position\": [10, 0, 0]"))
            .Run("near.json", "-s", "20x15");
        Assert.Equal(PictureFile.Read(raycaster.PathOf("near.png")).Rgb, PictureFile.Read(raycaster.PathOf("room-0001.png")).Rgb);
    }

    [Fact]
    public void AnAnimationHoldsEveryFrame()
    {
        Directory.CreateDirectory(raycaster.PathOf("film"));
        raycaster.Run("orbit", Room, "--frames", "4", "-s", "20x15", "-o", "film").Run("animate", "film", "-o", "film.png", "--fps", "300");
        Assert.Equal("film.png: 4 frames, 0.01 s\n", raycaster.Error);
        Assert.Equal(PictureFile.Read(raycaster.PathOf("film/room-0000.png")).Rgb, PictureFile.Read(raycaster.PathOf("film.png")).Rgb);

        var (sequence, data, frames) = (0, new MemoryStream(), new List<byte[]>());
        foreach (var (type, bytes) in PngMutation.Chunks(File.ReadAllBytes(raycaster.PathOf("film.png"))))
        {
            switch (type)
            {
                case "acTL":
                    Assert.Equal([0, 0, 0, 4, 0, 0, 0, 0], bytes);
                    break;
                case "fcTL":
                    Assert.Equal(sequence++, BinaryPrimitives.ReadInt32BigEndian(bytes));
                    Assert.Equal([0, 0, 0, 20, 0, 0, 0, 15, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 1, 44, 0, 0], bytes[4..]); // 1 / 300 s
                    EndFrame();
                    break;
                case "IDAT":
                    Assert.Empty(frames);
                    data.Write(bytes);
                    break;
                case "fdAT":
                    Assert.Equal(sequence++, BinaryPrimitives.ReadInt32BigEndian(bytes));
                    data.Write(bytes.AsSpan(4));
                    break;
            }
        }
        EndFrame();
        Assert.Equal(4, frames.Count);
        for (var i = 0; i < 4; i++) Assert.Equal(Decompressed(File.ReadAllBytes(raycaster.PathOf($"film/room-000{i}.png"))), frames[i]);

        void EndFrame()
        {
            if (data.Length > 0) frames.Add(Inflate(data.ToArray()));
            data.SetLength(0);
        }
    }

    [Fact]
    public void FramesOfAnAnimationAreOfOneSize()
    {
        raycaster.Run(Room, "-s", "20x15", "-o", "a.png").Run(Room, "-s", "20x16", "-o", "b.png").Run("animate", "a.png", "b.png", "-o", "film.png");
        Assert.Equal((2, "raycaster: cannot read b.png: it has 20 x 16 pixels, but a.png has 20 x 15: frames are of one size\n"),
            (raycaster.ExitCode, raycaster.Error));
        Assert.Equal(["a.png", "b.png"], raycaster.Files);
    }

    [Fact]
    public void ASheetShowsThePicturesRowByRow()
    {
        foreach (var (name, color) in ((string, string)[])[("a", "#100000"), ("b", "#002000"), ("c", "#000030")])
            raycaster.Write($"{name}.json", "{ \"camera\": { \"position\": [5, 0, 0], \"target\": [0, 0, 0] }, \"models\": [], \"background\": \"" +
                color + "\" }")
                .Run($"{name}.json", "-s", "30x20");
        raycaster.Run("sheet", ".", "-o", "sheet.png", "--columns", "2", "-s", "6x4")
            .Run("sheet", ".", "-o", "sheet.png", "--columns", "2", "-s", "6x4");
        Assert.Equal("sheet.png: 3 pictures, 24 x 20 pixels\n", raycaster.Error); // the sheet itself is not on it
        var sheet = PictureFile.Read(raycaster.PathOf("sheet.png"));
        for (var y = 0; y < 20; y++)
            for (var x = 0; x < 24; x++)
            {
                var (left, right, top, bottom) = (x is >= 4 and < 10, x is >= 14 and < 20, y is >= 4 and < 8, y is >= 12 and < 16);
                Assert.Equal(left && top ? (16, 0, 0) : right && top ? (0, 32, 0) : left && bottom ? (0, 0, 48) : (0, 0, 0), sheet[x, y]);
            }
    }

    [Fact]
    public void ASmallPictureIsTheMeanOfALargeOne()
    {
        PictureFile.Write(raycaster.PathOf("a.png"), Checks());
        raycaster.Run("sheet", "a.png", "-o", "sheet.png", "-s", "2x2");
        var sheet = PictureFile.Read(raycaster.PathOf("sheet.png"));
        Assert.Equal([(128, 100, 0), (128, 100, 0), (128, 100, 50), (128, 100, 50)],
            ((byte R, byte G, byte B)[])[sheet[4, 4], sheet[5, 4], sheet[4, 5], sheet[5, 5]]);

        static Picture Checks() // red alternates, green is even, blue is below
        {
            var picture = new Picture(8, 8);
            for (var y = 0; y < 8; y++)
                for (var x = 0; x < 8; x++) picture[x, y] = ((byte)((x + y) % 2 * 255), 100, (byte)(y / 4 * 50));
            return picture;
        }
    }

    private IEnumerable<string> Frames(string folder) => Directory.GetFiles(raycaster.PathOf(folder)).Select(path => Path.GetFileName(path)).Order();

    private static byte[] Decompressed(byte[] png) =>
        Inflate([.. PngMutation.Chunks(png).Where(chunk => chunk.Type == "IDAT").SelectMany(chunk => chunk.Data)]);

    private static byte[] Inflate(byte[] data)
    {
        using var lines = new MemoryStream();
        using (var decompressor = new ZLibStream(new MemoryStream(data), CompressionMode.Decompress)) decompressor.CopyTo(lines);
        return lines.ToArray();
    }
}
