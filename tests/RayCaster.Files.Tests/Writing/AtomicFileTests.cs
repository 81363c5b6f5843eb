using System.Runtime.Versioning;

namespace RayCaster.Files.Tests.Writing;

public sealed class AtomicFileTests : InTemporaryFolder
{
    [Theory]
    [InlineData(false)]
    [InlineData(true)]
    public void AFileIsThereAtTheEndAndATemporaryOneBefore(bool isReplaced)
    {
        var path = folder["room.png"];
        if (isReplaced) folder.Write("room.png", "old and longer"u8);
        AtomicFile.Write(path, file =>
        {
            file.Write("new"u8);
            file.Flush();
            Assert.Matches(@"^room\.png\.[0-9a-f]{8}\.tmp$", Assert.Single(folder.Names, name => name != "room.png"));
            if (isReplaced) Assert.Equal("old and longer", File.ReadAllText(path));
        });
        Assert.Equal("new", File.ReadAllText(path));
        Assert.Equal(["room.png"], folder.Names);
    }

    [Fact]
    public void AfterAnErrorTheOldFileStaysAndNothingIsLeft()
    {
        var path = folder.Write("room.png", "old"u8);
        Assert.Throws<InvalidOperationException>(() => AtomicFile.Write(path, file =>
        {
            using var writer = PictureWriter.Create(PictureFormat.Png, file, 1000, 1000);
            writer.WriteRows(new byte[3000 * 500]);
            writer.Finish();
        }));
        Assert.Equal("old", File.ReadAllText(path));
        Assert.Equal(["room.png"], folder.Names);
    }

    /// <summary>An error of the drawing is not taken for one of the file.</summary>
    [Fact]
    public void AnErrorOfTheWriterStaysWhatItIs() => Assert.Throws<ArgumentOutOfRangeException>(
        () => AtomicFile.Write(folder["room.png"], _ => throw new ArgumentOutOfRangeException("width")));

    [Theory(Skip = "needs special rights there", SkipWhen = nameof(Here.IsWindows), SkipType = typeof(Here))]
    [InlineData("real/precious", "real/precious")]
    [InlineData("real/precious", "real/new")] // the link leads nowhere: what it names is made
    [InlineData("link/../precious", "precious")]
    [InlineData("second", "real/precious")]
    public void ALinkIsFollowed(string leadsTo, string written)
    {
        Directory.CreateDirectory(folder["real"]);
        if (!written.EndsWith("new", StringComparison.Ordinal)) folder.Write(written, "old"u8);
        else leadsTo = written;
        Directory.CreateDirectory(folder["real/deep"]);
        File.CreateSymbolicLink(folder["second"], "real/precious");
        Directory.CreateSymbolicLink(folder["link"], "real");
        File.CreateSymbolicLink(folder["room.png"], leadsTo);
        AtomicFile.Write(folder["room.png"], file =>
        {
            file.Write("new"u8);
            Assert.Contains(Directory.GetFiles(Path.GetDirectoryName(folder[written])!), name => name.EndsWith(".tmp", StringComparison.Ordinal));
        });
        Assert.Equal("new", File.ReadAllText(folder[written]));
        Assert.Equal(leadsTo, new FileInfo(folder["room.png"]).LinkTarget);
        Assert.Empty(Directory.GetFiles(folder["real"], "*.tmp"));
    }

    /// <summary>".." in a link counts from the folder in which the link is, not from the path by which it was reached.</summary>
    [Fact(Skip = "needs special rights there", SkipWhen = nameof(Here.IsWindows), SkipType = typeof(Here))]
    public void ALinkInALinkedFolderCountsFromItsOwnFolder()
    {
        Directory.CreateDirectory(folder["real/deep"]);
        Directory.CreateSymbolicLink(folder["short"], "real/deep");
        File.CreateSymbolicLink(folder["real/deep/room.png"], "../precious");
        Write("short/room.png");
        Assert.Equal("new", File.ReadAllText(folder["real/precious"]));
    }

    [Fact(Skip = "needs special rights there", SkipWhen = nameof(Here.IsWindows), SkipType = typeof(Here))]
    public void ACircleOfLinksIsRefused()
    {
        File.CreateSymbolicLink(folder["room.png"], "other");
        File.CreateSymbolicLink(folder["other"], "room.png");
        Refused(folder["room.png"], $"cannot write {folder["room.png"]}: symbolic links lead in a circle", ["other", "room.png"]);
    }

    [Fact(Skip = "no mkfifo there", SkipWhen = nameof(Here.IsWindows), SkipType = typeof(Here))]
    public async Task APipeGetsTheBytesAndStays()
    {
        Shell("mkfifo pipe.png");
        var reader = Task.Run(() => File.ReadAllText(folder["pipe.png"]));
        Write("pipe.png");
        Assert.Equal("new", await reader.WaitAsync(TimeSpan.FromSeconds(20)));
        Assert.Equal(["pipe.png"], folder.Names);
        Shell("test -p pipe.png");
    }

    /// <summary>The reader of a pipe gets a whole picture or nothing.</summary>
    [Fact(Skip = "no mkfifo there", SkipWhen = nameof(Here.IsWindows), SkipType = typeof(Here))]
    public void APipeGetsNothingOfAFileThatFails()
    {
        Shell("mkfifo pipe.png");
        Assert.Throws<TimeoutException>(() => AtomicFile.Write(folder["pipe.png"], file =>
        {
            file.Write(new byte[1 << 17]);
            throw new TimeoutException();
        })); // without a reader this would wait for ever, if the pipe were opened
    }

    [Fact(Skip = "other systems have other numbers of devices", SkipUnless = nameof(Here.IsLinux), SkipType = typeof(Here))]
    public void ADeviceIsNotReplaced()
    {
        Shell("ln -s /dev/null link; mknod null c 1 3 2>/dev/null; test ! -e null || (: >null) 2>/dev/null || rm null");
        foreach (var device in (string[])["link", "null"])
        {
            if (device == "null" && !File.Exists(folder["null"])) continue; // only root may make one
            Write(device);
            Shell($"test -c {device}");
        }
        // not a real one, should this fail
        var refused = Assert.Throws<ProblemException>(() => AtomicFile.Write("/dev/raycaster-test", _ => { }));
        Assert.Equal("cannot write /dev/raycaster-test: its folder is for devices, not for files", refused.Message);
    }

    [Theory(Skip = "has no such device", SkipUnless = nameof(Here.IsLinux), SkipType = typeof(Here))]
    [InlineData("/dev/full", "the disk is full")]
    [InlineData("/dev/fd/9999", "nothing is open by this number")]
    public void ADeviceThatFailsIsNamed(string device, string reason)
    {
        var refused = Assert.Throws<ProblemException>(() => AtomicFile.Write(device, file => file.Write("new"u8)));
        Assert.Equal($"cannot write {device}: {reason}", refused.Message);
    }

    /// <summary>What a process has open gets the bytes where it is: in the middle of a file, too.</summary>
    [Theory(Skip = "has no such folder", SkipUnless = nameof(Here.IsLinux), SkipType = typeof(Here))]
    [InlineData("/proc/self/fd/{0}")]
    [InlineData("/dev/fd/{0}")]
    public void WhatIsOpenGetsTheBytes(string name)
    {
        using (var open = new FileStream(folder["room.png"], FileMode.Create, FileAccess.Write, FileShare.ReadWrite, bufferSize: 0))
        {
            open.Write("before "u8);
            AtomicFile.Write(name.Replace("{0}", $"{open.SafeFileHandle.DangerousGetHandle()}"), file => file.Write("new"u8));
        }
        Assert.Equal("before new", File.ReadAllText(folder["room.png"]));
    }

    [Theory]
    [InlineData("aux.png", true)]
    [InlineData("NUL", true)]
    [InlineData("con.tar.gz", true)]
    [InlineData("com1.ppm", true)]
    [InlineData("lpt² .png", true)]
    [InlineData("com0.ppm", false)]
    [InlineData("console.png", false)]
    [InlineData("auxiliary.png", false)]
    [InlineData("my.nul", false)]
    public void DevicesOfWindowsHaveNames(string name, bool isDevice)
    {
        Assert.Equal(isDevice, PathResolver.IsDeviceOnWindows(name));
        if (isDevice && OperatingSystem.IsWindows())
            Assert.Equal($"cannot write {folder[name]}: {name} is the name of a device on Windows; choose another",
                Assert.Throws<ProblemException>(() => Write(name)).Message);
    }

    [Fact(Skip = "open files can be replaced", SkipUnless = nameof(Here.IsWindows), SkipType = typeof(Here))]
    public void AFileThatIsOpenElsewhereIsNotReplaced()
    {
        using (new FileStream(folder.Write("room.png", "old"u8), FileMode.Open, FileAccess.Read, FileShare.Read))
            Refused(folder["room.png"], $"cannot write {folder["room.png"]}: another program has it open; close it there");
    }

    /// <summary>A picture that another program is writing, as viewers and editors hold them on Windows.</summary>
    [Fact]
    public void AFileThatIsOpenElsewhereIsRead()
    {
        folder.Write("room.ppm", "P6 1 1 255\nabc"u8);
        folder.Write("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"u8);
        using var picture = new FileStream(folder["room.ppm"], FileMode.Open, FileAccess.ReadWrite, FileShare.ReadWrite | FileShare.Delete);
        using var mesh = new FileStream(folder["a.obj"], FileMode.Open, FileAccess.ReadWrite, FileShare.ReadWrite | FileShare.Delete);
        Assert.Equal("abc"u8, PictureFile.Read(folder["room.ppm"]).Rgb);
        Assert.Equal([0, 1, 2], MeshFile.Read(folder["a.obj"]).Indices);
    }

    [Fact]
    public void AnEmptyFileIsAFile()
    {
        folder.Write("room.png", ""u8);
        Write("room.png");
        Assert.Equal("new", File.ReadAllText(folder["room.png"]));
    }

    /// <summary>As of an account of a directory service.</summary>
    [Theory(Skip = "has no such owners", SkipWhen = nameof(Here.IsWindows), SkipType = typeof(Here))]
    [InlineData("chown 3000000:3000000 room.png; chmod 666 room.png", "only root may give a file away")]
    [InlineData("chmod 200 room.png", "")]
    public void AnEmptyFileIsAFileWhoeverMayReadIt(string change, string needs)
    {
        folder.Write("room.png", ""u8);
        Assert.SkipUnless(needs == "" || Environment.IsPrivilegedProcess, needs);
        Shell(change);
        Write("room.png");
        Assert.Equal(["room.png"], folder.Names);
        Assert.Equal(3, new FileInfo(folder["room.png"]).Length);
    }

    [Fact(Skip = "has other rights", SkipWhen = nameof(Here.IsWindows), SkipType = typeof(Here))]
    [UnsupportedOSPlatform("windows")]
    public void TheOldFilesRightsStay()
    {
        const UnixFileMode mine = UnixFileMode.UserRead | UnixFileMode.UserWrite;
        File.SetUnixFileMode(folder.Write("room.png", "old"u8), mine);
        // The temporary one is no more open to others.
        AtomicFile.Write(folder["room.png"], _ => Assert.All(folder.Names, name => Assert.Equal(mine, new FileInfo(folder[name]).UnixFileMode)));
        Assert.Equal(mine, File.GetUnixFileMode(folder["room.png"]));
    }

    [Theory]
    [InlineData(242, "x")]
    [InlineData(255, "x")]
    [InlineData(251, "\u00e4")]
    public void ANameMayBeAsLongAsTheSystemTakes(int bytes, string letter)
    {
        var name = string.Concat(Enumerable.Repeat(letter, (bytes - 4) / System.Text.Encoding.UTF8.GetByteCount(letter))) + ".png";
        Write(name);
        Assert.Equal([name], folder.Names);
    }

    [Fact]
    public void AReadOnlyFileIsNotReplaced()
    {
        var path = folder.Write("room.png", "old"u8);
        File.SetAttributes(path, FileAttributes.ReadOnly);
        Refused(path, $"cannot write {path}: the old file is read-only");
        File.SetAttributes(path, FileAttributes.Normal);
    }

    [Fact]
    public void AFileIsNotAFolder()
    {
        folder.Write("room.png", "old"u8);
        var path = folder["room.png/x.png"];
        Refused(path, $"cannot write {path}: its folder does not exist\n  make the folder {folder["room.png"]} first");
    }

    [Theory]
    [InlineData("", "'' is no file name")]
    [InlineData("a\0.png", @"'a\x00.png' is no file name")]
    public void AnImpossibleNameIsRefused(string path, string message)
    {
        Assert.Equal(message, Assert.Throws<ProblemException>(() => AtomicFile.Write(path, _ => { })).Message);
        Assert.Equal(message, Assert.Throws<ProblemException>(() => PictureFile.Read(path)).Message);
        Assert.EndsWith(message, Assert.Single(SceneReader.Read(path).Problems).Message);
    }

    [Fact]
    public void ATooLongNameIsRefused()
    {
        var name = folder[new string('x', 300) + ".png"];
        Refused(name, $"cannot write {name}: the name is too long", left: []);
    }

    [Fact]
    public void AFailureAtTheEndLeavesNoTemporaryFile()
    {
        Assert.Throws<ProblemException>(() => AtomicFile.Write(
            folder["room.png"], _ => Directory.CreateDirectory(folder["room.png"]))); // comes in between
        Assert.Equal(["room.png"], folder.Names);
    }

    [Fact]
    public void ManyWritersOfOneTargetDoNotDisturbEachOther()
    {
        Parallel.For(0, 400, new ParallelOptions { MaxDegreeOfParallelism = 8 }, i =>
        {
            var writing = Record.Exception(() => AtomicFile.Write(folder["room.png"], file =>
            {
                file.Write(BitConverter.GetBytes(i));
                if (i % 3 == 0) throw new TimeoutException();
            }));
            Assert.Equal(i % 3 == 0, writing is not null);
        });
        Assert.Equal(["room.png"], folder.Names);
        Assert.Equal(4, File.ReadAllBytes(folder["room.png"]).Length);
    }

    private void Shell(string command)
    {
        using var shell = System.Diagnostics.Process.Start(new System.Diagnostics.ProcessStartInfo("sh", ["-c", command])
        {
            WorkingDirectory = folder[""],
        })!;
        shell.WaitForExit();
        Assert.Equal(0, shell.ExitCode);
    }

    private void Write(string name) => AtomicFile.Write(folder[name], file => file.Write("new"u8));

    private void Refused(string path, string message, string[]? left = null)
    {
        Assert.Equal(message, Assert.Throws<ProblemException>(() => AtomicFile.Write(path, _ => { })).Message);
        Assert.Equal(left ?? ["room.png"], folder.Names);
    }
}
