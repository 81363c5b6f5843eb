using System.Net;
using System.Net.NetworkInformation;
using System.Net.Sockets;
using System.Net.WebSockets;

namespace RayCaster.Live.Tests;

/// <summary>Other users of this machine and other pages in the same browser have no access.</summary>
public class AttackTests(LiveServerFixture fixture) : IClassFixture<LiveServerFixture>
{
    private readonly LivePage page = fixture.Page;
    private static readonly HttpClient client = new(new HttpClientHandler { UseCookies = false, AllowAutoRedirect = false });

    [Theory]
    [InlineData("")]
    [InlineData("00000000000000000000000000000000")]
    public async Task WithoutTheTokenNoSceneIsShownAndNoPictureTaken(string token)
    {
        Assert.Equal(HttpStatusCode.Forbidden, (await PostAsync(new byte[1], token)).StatusCode);
        if (token != "") await Assert.ThrowsAsync<WebSocketException>(() => page.ConnectAsync(token: token));
        foreach (var path in new[] { "/", "/main.js", "/server.js", "/nothing" })
        {
            var answer = await SendAsync(path);
            Assert.DoesNotContain(page.Token, await answer.Content.ReadAsStringAsync());
            Assert.False(answer.Headers.Contains("Set-Cookie")); // every port of this machine would get it
        }
    }

    [Theory]
    [InlineData("evil.example")] // DNS rebinding: the name leads here, but it is not ours
    [InlineData("127.0.0.1")]
    [InlineData("127.0.0.1.evil.example:80")]
    public async Task OtherNamesOfThisMachineAreRefused(string host)
    {
        Assert.Equal(HttpStatusCode.Forbidden, (await SendAsync("/", ("Host", host))).StatusCode);
    }

    [Theory]
    [InlineData("http://evil.example")]
    [InlineData("http://localhost:1")] // another program's page on this machine
    [InlineData("null")]
    [InlineData("")]
    public async Task OtherPagesAreRefusedEvenWithTheToken(string origin)
    {
        await Assert.ThrowsAsync<WebSocketException>(() => page.ConnectAsync(origin));
        Assert.Equal(HttpStatusCode.Forbidden, (await PostAsync(new byte[1], page.Token, origin)).StatusCode);
    }

    [Theory]
    [InlineData("/scene.json")]
    [InlineData("/../scene.json")]
    [InlineData("/..%2fscene.json")]
    [InlineData("/%2e%2e/%2e%2e/%2e%2e/%2e%2e/etc/passwd")]
    [InlineData("/....//....//etc/passwd")]
    [InlineData("//etc/passwd")]
    [InlineData("/Site/index.html")]
    [InlineData("/raycaster-live.dll")]
    public async Task NoFileOfTheDiskIsServed(string path)
    {
        var answer = await RawAsync($"GET {path} HTTP/1.1\r\nHost: 127.0.0.1:{page.Server.Port}\r\nConnection: close\r\n\r\n");
        Assert.Matches("^HTTP/1.1 (404|400) ", answer);
    }

    [Fact]
    public async Task EveryAnswerForbidsWhatIsNotOfThePage()
    {
        foreach (var path in new[] { "/", "/main.js", "/nothing" })
        {
            var answer = await SendAsync(path);
            var policy = Assert.Single(answer.Headers.GetValues("Content-Security-Policy"));
            Assert.Contains("default-src 'none'", policy);
            Assert.Contains("frame-ancestors 'none'", policy);
            Assert.DoesNotContain("unsafe", policy);
            Assert.Equal("nosniff", Assert.Single(answer.Headers.GetValues("X-Content-Type-Options")));
        }
    }

    [Fact]
    public void ItListensOnNoOtherAddressOfThisMachine()
    {
        var listeners = IPGlobalProperties.GetIPGlobalProperties().GetActiveTcpListeners().Where(listener => listener.Port == page.Server.Port);
        Assert.NotEmpty(listeners);
        Assert.All(listeners, listener => Assert.True(IPAddress.IsLoopback(listener.Address), $"{listener}"));
    }

    [Fact]
    public async Task APictureLargerThanTheScenesIsComparedAndToldByItsSize()
    {
        using var file = new MemoryStream();
        PictureFile.Write(file, new Picture(60, 45), PictureFormat.Png);
        await page.ConnectAsync();
        Assert.Equal(HttpStatusCode.NoContent, (await PostAsync(file.ToArray())).StatusCode);
        await page.MessageAsync("comparison", message => $"{message.GetProperty("text")}".Contains("60 x 45")); // after another test's picture
    }

    [Fact]
    public async Task AnUploadLargerThanThePictureIsCutOff()
    {
        var answer = await PostAsync(new byte[18 * 1_000_000 + 65_537]);
        Assert.Equal(HttpStatusCode.RequestEntityTooLarge, answer.StatusCode);
    }

    [Fact]
    public async Task APictureInPaddedTextIsTaken()
    {
        var file = new StringBuilder("P3 1000 1000 255\n").Insert(17, "  255    0  128", 1_000_000);
        Assert.Equal(HttpStatusCode.NoContent, (await PostAsync(Encoding.ASCII.GetBytes($"{file}"))).StatusCode);
    }

    [Fact]
    public async Task AnUploadThatPromisesAHugePictureIsRefusedByItsHeader()
    {
        using var file = new MemoryStream();
        using (var writer = PictureWriter.Create(PictureFormat.Png, file, 4000, 4000))
        {
            for (var line = 0; line < 4000; line++) writer.WriteRows(new byte[12_000]);
            writer.Finish();
        }
        Assert.True(file.Length < 12 * 40 * 30 + 65_536, "the file itself is short enough");
        var answer = await PostAsync(file.ToArray());
        Assert.Equal(HttpStatusCode.UnprocessableEntity, answer.StatusCode);
        Assert.Contains("4,000 × 4,000", await answer.Content.ReadAsStringAsync());
    }

    [Theory]
    [InlineData("PUT", "/mine")]
    [InlineData("DELETE", "/")]
    [InlineData("POST", "/")]
    [InlineData("POST", "/live")]
    public async Task NothingElseIsChangedByARequest(string method, string path)
    {
        using var request = new HttpRequestMessage(new(method), page.Root + path) { Content = new ByteArrayContent([]) };
        request.Headers.Add("Authorization", page.Token);
        request.Headers.Add("Origin", page.Root);
        Assert.Equal(HttpStatusCode.MethodNotAllowed, (await client.SendAsync(request)).StatusCode);
        Assert.Equal(["scene.json"], page.Folder.Names);
    }

    [Theory]
    [InlineData("nonsense")]
    [InlineData("[]")]
    [InlineData("""{"turn":[1e999,0]}""")]
    [InlineData("""{"turn":[]}""")]
    [InlineData("""{"camera":{"position":[0,0,0]}}""")]
    [InlineData("""{"open":"/etc/passwd"}""")]
    [InlineData("""{"hint":"99"}""")]
    [InlineData("""{"map":"x"}""")]
    [InlineData("""{"diagnose":1}""")]
    public async Task AMalformedMessageEndsOnlyItsConnection(string words)
    {
        await page.ConnectAsync();
        await page.AskAsync(words);
        await Assert.ThrowsAnyAsync<Exception>(() => page.MessageAsync("never"));
        await page.ConnectAsync();
        await page.FrameAsync();
    }

    [Theory]
    [InlineData("127.0.0.1")]
    [InlineData("localhost")]
    [InlineData("[::1]")]
    public async Task ThisMachineReachesThePageByEachOfItsNames(string name)
    {
        Assert.SkipWhen(name == "[::1]" && !Socket.OSSupportsIPv6, "no IPv6 here");
        var answer = await client.GetAsync($"http://{name}:{page.Server.Port}/");
        Assert.Equal(HttpStatusCode.OK, answer.StatusCode);
    }

    [Fact]
    public async Task APortThatIsTakenIsToldInWords()
    {
        var problem = await Assert.ThrowsAsync<ProblemException>(() => LiveServer.StartAsync(page.Scene, port: page.Server.Port));
        Assert.Contains($"port {page.Server.Port} is taken", problem.Message);
    }

    private Task<HttpResponseMessage> SendAsync(string path, params (string Name, string Value)[] headers)
    {
        var request = new HttpRequestMessage(HttpMethod.Get, page.Root + path);
        foreach (var (name, value) in headers)
        {
            request.Headers.Remove(name);
            request.Headers.TryAddWithoutValidation(name, value);
        }
        return client.SendAsync(request);
    }

    private Task<HttpResponseMessage> PostAsync(byte[] bytes, string? token = null, string? origin = null)
    {
        var request = new HttpRequestMessage(HttpMethod.Post, page.Root + "/mine?name=mine.png") { Content = new ByteArrayContent(bytes) };
        request.Headers.TryAddWithoutValidation("Authorization", token ?? page.Token);
        if (origin != "") request.Headers.Add("Origin", origin ?? page.Root);
        request.Headers.ExpectContinue = true; // the client sends no body that the server refuses by its length
        return client.SendAsync(request);
    }

    private async Task<string> RawAsync(string request)
    {
        using var tcp = new TcpClient();
        await tcp.ConnectAsync(IPAddress.Loopback, page.Server.Port);
        await tcp.GetStream().WriteAsync(Encoding.ASCII.GetBytes(request));
        using var reader = new StreamReader(tcp.GetStream());
        return await reader.ReadToEndAsync();
    }
}

/// <summary>One server for all attacks: none of them leaves a trace in it.</summary>
public sealed class LiveServerFixture : IAsyncLifetime
{
    internal LivePage Page { get; private set; } = null!;

    public async ValueTask InitializeAsync() => Page = await LivePage.OpenAsync();

    public ValueTask DisposeAsync() => Page.DisposeAsync();
}
