namespace RayCaster.Files.Tests.Parts;

public sealed class PartSetTests : InTemporaryFolder
{
    [Fact]
    public void PartsInAnyOrderMakeThePicture()
    {
        string[] files = [Part("c", 7, 9), Part("a", 0, 2), Part("b", 3, 6)];
        var (set, lines) = (new PartSet(files), new List<byte[]>());
        set.Read(line => lines.Add([.. line]));
        Assert.Equal((3, 10), set.Size);
        Assert.Equal(Enumerable.Range(0, 10).Select(line => Enumerable.Repeat((byte)line, 9)), lines);
    }

    [Fact]
    public void ItSaysWhichLinesAreMissing()
    {
        var set = new PartSet([Part("b", 7, 7), Part("a", 2, 4)]);
        Assert.Equal(["0..1", "5..6", "8..9"], set.Missing.Select(lines => lines.ToString()));
        Assert.Empty(set.Problems);
    }

    [Fact]
    public void APartWithinAnotherOverlaps()
    {
        var set = new PartSet([Part("a", 0, 8), Part("b", 2, 3), Part("c", 8, 9)]);
        Assert.Equal([$"the lines 2..3 are in {folder["a"]} and in {folder["b"]}", $"the lines 8..8 are in {folder["a"]} and in {folder["c"]}"],
            set.Problems);
    }

    [Fact]
    public void EqualPartsOverlapToo() => Assert.Single(new PartSet([Part("a", 0, 9), Part("b", 0, 9)]).Problems);

    [Fact]
    public void AnotherSizeSceneOrVersionDoesNotBelong()
    {
        var set = new PartSet(
        [
            Part("a", 0, 2), Part("b", 3, 4, facts => facts with { Height = 11 }),
            Part("c", 5, 6, facts => facts with { Digest = "fedcba9876543210" }),
            Part("d", 7, 9, facts => facts with { Version = "2.0.0" }),
        ]);
        Assert.Equal(
        [
            $"{folder["b"]} belongs to a picture of 3 x 11 pixels, {folder["a"]} to one of 3 x 10",
            $"{folder["c"]} shows another scene than {folder["a"]}: fedcba987654… instead of 0123456789ab…",
            $"{folder["d"]} was drawn by version 2.0.0, {folder["a"]} by 1.0.0",
        ], set.Problems);
    }

    [Fact]
    public void OnlyAChosenPictureMustBeAPart()
    {
        var picture = ProjectFolder.PathOf("docs/room.png");
        Assert.Equal(
            [$"{picture} is a picture, but does not say which part of which; the command part draws parts"],
            new PartSet([Part("a", 0, 9), picture]).Problems);
        Assert.Empty(new PartSet([Part("a", 0, 9), picture], path => path != picture).Problems);
    }

    [Fact]
    public void ADamagedPartIsNamed()
    {
        var path = Part("a", 0, 9);
        var bytes = File.ReadAllBytes(path);
        bytes[^20] ^= 1; // within the pixels
        folder.Write("a", bytes);
        var message = Assert.Throws<ProblemException>(() => new PartSet([path]).Read(_ => { })).Message;
        Assert.Matches("^cannot read .*: its chunk IDAT at byte [0-9]+ is damaged: the checksum is wrong$", message);
    }

    [Fact]
    public void WhatCannotBeReadHoldsNoLines()
    {
        var damaged = Part("b", 5, 9);
        var bytes = File.ReadAllBytes(damaged);
        bytes[^20] ^= 1;
        folder.Write("b", bytes);
        var set = new PartSet([Part("a", 0, 3), damaged, folder.Write("c", "no picture"u8)], whole: true);
        Assert.Equal(["4..9"], set.Missing.Select(lines => lines.ToString()));
        Assert.Equal([$"cannot read {damaged}", $"cannot read {folder["c"]}"], set.Unreadable.Select(reason => reason.Split(": ")[0]));
    }

    /// <summary>Lines whose bytes are their numbers.</summary>
    private string Part(string name, int first, int last, Func<PartFacts, PartFacts>? change = null)
    {
        var facts = new PartFacts(3, 10, new(first, last), "0123456789abcdef", "1.0.0");
        using var output = new MemoryStream();
        using var writer = PictureWriter.Create(PictureFormat.Png, output, 3, last - first + 1, (change?.Invoke(facts) ?? facts).PngText);
        for (var line = first; line <= last; line++) writer.WriteRows([.. Enumerable.Repeat((byte)line, 9)]);
        writer.Finish();
        return folder.Write(name, output.ToArray());
    }
}
