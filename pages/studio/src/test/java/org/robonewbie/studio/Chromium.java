package org.robonewbie.studio;

import com.google.gson.JsonElement;
import com.google.gson.JsonNull;
import com.google.gson.JsonObject;
import com.google.gson.JsonPrimitive;
import java.io.IOException;
import java.nio.file.Path;
import java.util.Base64;
import java.util.List;
import java.util.Map;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionException;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.TimeUnit;
import java.util.regex.Pattern;

/** A headless Chromium, controlled by the Chrome DevTools protocol. */
final class Chromium implements AnyBrowser, AutoCloseable {

    private static final long PATIENCE_SECONDS = 120;

    /** Device pixels per CSS pixel, in both directions. */
    private static final double COARSE = 0.25;

    private static final String NO_SHAPES = """
            for (const order of ['drawElements', 'drawArrays', 'drawElementsInstanced', 'drawArraysInstanced']) {
              WebGL2RenderingContext.prototype[order] = () => undefined;
            }
            """;

    /** Keys that the browser handles itself. */
    private static final Map<String, Integer> VIRTUAL_KEYS = Map.of("Tab", 9, "Enter", 13, "ArrowDown", 40);

    private static final Pattern PAGE_IS_LEFT = Pattern.compile(
            "context was destroyed|Cannot find (default execution )?context|navigated or closed|Promise was collected");

    private final BrowserProcess process;
    private final DevTools tools;
    private final List<String> complaints = new CopyOnWriteArrayList<>();
    private volatile CompletableFuture<String> downloaded = new CompletableFuture<>();
    private volatile String downloadName = "";
    private volatile String session = "";
    private String context = "";
    private String undrawn = "";
    private boolean isDrawn = true;
    private double sharpness = 1;
    private int width;
    private int height;

    private Chromium(BrowserProcess process) {
        this.process = process;
        this.tools = new DevTools(process.devTools(), this::receiveEvent);
    }

    /** Starts a browser with a page that is drawn sharply. */
    static Chromium open(int width, int height) throws IOException {
        Chromium browser = start();
        browser.openPage(width, height);
        return browser;
    }

    /** Starts a browser without a page. */
    static Chromium start() throws IOException {
        return new Chromium(BrowserProcess.start());
    }

    /** Opens a page with fresh state and closes the previous one. */
    void openPage(int width, int height) {
        closePage();
        context = call("Target.createBrowserContext", new JsonObject())
                .get("browserContextId")
                .getAsString();
        JsonObject page = new JsonObject();
        page.addProperty("url", "about:blank");
        page.addProperty("browserContextId", context);
        JsonObject attach = new JsonObject();
        attach.add("targetId", call("Target.createTarget", page).get("targetId"));
        attach.addProperty("flatten", true);
        session = call("Target.attachToTarget", attach).get("sessionId").getAsString();
        for (String domain : List.of("Page", "Runtime", "Log", "Network")) {
            call(domain + ".enable", new JsonObject());
        }
        resize(width, height);
    }

    private void closePage() {
        session = "";
        undrawn = "";
        if (!context.isEmpty()) {
            JsonObject left = new JsonObject();
            left.addProperty("browserContextId", context);
            call("Target.disposeBrowserContext", left);
        }
        complaints.clear();
    }

    void resize(int width, int height) {
        this.width = width;
        this.height = height;
        JsonObject metrics = new JsonObject();
        metrics.addProperty("width", width);
        metrics.addProperty("height", height);
        metrics.addProperty("deviceScaleFactor", sharpness);
        metrics.addProperty("mobile", false);
        call("Emulation.setDeviceMetricsOverride", metrics);
    }

    /**
     * Draws one device pixel for 16 CSS pixels, and no shapes of 3D scenes, in pages that are visited from now on: without a graphics card
     * they take most of the time. Positions and sizes do not change.
     */
    void drawCoarsely() {
        sharpness = COARSE;
        resize(width, height);
        if (undrawn.isEmpty()) {
            undrawn = runBeforePages(NO_SHAPES);
        }
    }

    /** Draws every pixel of pages that are visited from now on, for screenshots. */
    void drawSharply() {
        sharpness = 1;
        resize(width, height);
        if (!undrawn.isEmpty()) {
            forgetScript(undrawn);
            undrawn = "";
        }
    }

    /** Opens an address and waits until the previous page is gone and this one has loaded. */
    @Override
    public void visit(String address) {
        JsonObject place = new JsonObject();
        place.addProperty("url", address);
        evaluate("window.isLeft = true");
        isDrawn = undrawn.isEmpty();
        boolean isOther = call("Page.navigate", place).has("loaderId");
        await((isOther ? "!window.isLeft && " : "") + "document.readyState === 'complete'");
    }

    /** Evaluates a JavaScript expression in the page. */
    @Override
    public JsonElement evaluate(String expression) {
        JsonObject parameters = new JsonObject();
        parameters.addProperty("expression", expression);
        parameters.addProperty("returnByValue", true);
        parameters.addProperty("awaitPromise", true);
        JsonObject answer = call("Runtime.evaluate", parameters);
        if (answer.has("exceptionDetails")) {
            throw new AssertionError(expression + " failed: " + answer.get("exceptionDetails"));
        }
        JsonElement value = answer.getAsJsonObject("result").get("value");
        return value == null ? JsonNull.INSTANCE : value;
    }

    /** Waits until a JavaScript condition holds in the page, which polls it and answers once it does. */
    @Override
    public void await(String condition) {
        String guarded = "(() => { try { return Boolean(" + condition + "); } catch { return false; } })()";
        String promise = "new Promise((answer) => { const look = () => " + guarded
                + " ? answer(true) : setTimeout(look, 15); look(); })";
        try {
            boolean held = holds(promise);
            while (!held) {
                held = holds(promise);
            }
        } catch (CompletionException tooLate) {
            throw new AssertionError(
                    "Not within " + PATIENCE_SECONDS + " s: " + condition + "; page says " + complaints + " and shows "
                            + evaluate("document.body.innerText"),
                    tooLate);
        }
    }

    /** Evaluates a promise; false while the page is being replaced, so that the next page is asked again. */
    private boolean holds(String promise) {
        try {
            return evaluate(promise).getAsBoolean();
        } catch (CompletionException e) {
            if (PAGE_IS_LEFT.matcher(String.valueOf(e.getMessage())).find()) {
                return false;
            }
            throw e;
        }
    }

    /** Runs a command that starts a download, and waits until the file is complete. */
    Path download(Path folder, Runnable command) {
        downloaded = new CompletableFuture<>();
        JsonObject behavior = new JsonObject();
        behavior.addProperty("behavior", "allow");
        behavior.addProperty("browserContextId", context);
        behavior.addProperty("downloadPath", folder.toString());
        behavior.addProperty("eventsEnabled", true);
        tools.send("", "Browser.setDownloadBehavior", behavior)
                .orTimeout(PATIENCE_SECONDS, TimeUnit.SECONDS)
                .join();
        command.run();
        return folder.resolve(
                downloaded.orTimeout(PATIENCE_SECONDS, TimeUnit.SECONDS).join());
    }

    /** Waits while the page continues to run. */
    void rest(int seconds) {
        evaluate("new Promise((answer) => setTimeout(answer, " + 1000 * seconds + "))");
    }

    /** Size of the script heap after a garbage collection. */
    long heapBytes() {
        call("HeapProfiler.collectGarbage", new JsonObject());
        return evaluate("performance.memory.usedJSHeapSize").getAsLong();
    }

    /** Registers a script that runs in each page before its own scripts, and returns its identifier. */
    String runBeforePages(String source) {
        JsonObject script = new JsonObject();
        script.addProperty("source", source);
        return call("Page.addScriptToEvaluateOnNewDocument", script)
                .get("identifier")
                .getAsString();
    }

    void forgetScript(String identifier) {
        JsonObject script = new JsonObject();
        script.addProperty("identifier", identifier);
        call("Page.removeScriptToEvaluateOnNewDocument", script);
    }

    /** Clicks as soon as the element exists and is enabled; a disabled one would swallow the click. */
    @Override
    public void click(String selector) {
        clickElement("document.querySelector(" + quoted(selector) + ")");
    }

    /** Clicks the result of a JavaScript expression as soon as it exists and is enabled. */
    void clickElement(String expression) {
        await("(() => { const found = " + expression + "; const ready = found && !found.disabled;"
                + " if (ready) { found.click(); } return ready; })()");
    }

    /** Fills a field or selects from a list as soon as it is enabled, then moves the focus away. */
    void fill(String selector, String value) {
        await("(() => { const field = document.querySelector(" + quoted(selector) + ");"
                + " const ready = field && !field.disabled;"
                + " if (ready) { field.focus(); field.value = " + quoted(value) + ";"
                + " field.dispatchEvent(new Event('input', {bubbles: true}));"
                + " field.dispatchEvent(new Event('change', {bubbles: true})); field.blur(); } return ready; })()");
    }

    void press(String key) {
        press(key, 0);
    }

    /** Presses a key with modifiers: 1 is Alt, 2 Ctrl, 8 Shift. */
    void press(String key, int modifiers) {
        for (String type : List.of("keyDown", "keyUp")) {
            JsonObject event = new JsonObject();
            event.addProperty("type", type);
            event.addProperty("key", key);
            event.addProperty("modifiers", modifiers);
            if (VIRTUAL_KEYS.containsKey(key)) {
                event.addProperty("windowsVirtualKeyCode", VIRTUAL_KEYS.get(key));
            }
            if (type.equals("keyDown") && modifiers == 0 && (key.length() == 1 || key.equals("Enter"))) {
                event.addProperty("text", key.equals("Enter") ? "\r" : key);
            }
            call("Input.dispatchKeyEvent", event);
        }
    }

    void mouse(String type, double x, double y) {
        mouse(type, x, y, 0);
    }

    /** Moves or presses the mouse with modifiers: 1 is Alt, 2 Ctrl, 8 Shift. */
    void mouse(String type, double x, double y, int modifiers) {
        JsonObject event = new JsonObject();
        event.addProperty("type", type);
        event.addProperty("x", x);
        event.addProperty("y", y);
        event.addProperty("button", "left");
        event.addProperty("buttons", type.equals("mouseReleased") ? 0 : 1);
        event.addProperty("clickCount", 1);
        event.addProperty("modifiers", modifiers);
        call("Input.dispatchMouseEvent", event);
    }

    byte[] screenshot() {
        if (sharpness < 1 || !isDrawn) {
            throw new IllegalStateException("The page is not drawn. Call drawSharply() before visiting it.");
        }
        JsonObject form = new JsonObject();
        form.addProperty("format", "png");
        return Base64.getDecoder()
                .decode(call("Page.captureScreenshot", form).get("data").getAsString());
    }

    /** Lists errors and warnings of the page, and requests to other computers. */
    List<String> complaints() {
        return List.copyOf(complaints);
    }

    void forgetComplaints() {
        complaints.clear();
    }

    static String quoted(String text) {
        return new JsonPrimitive(text).toString();
    }

    private JsonObject call(String method, JsonObject parameters) {
        return tools.send(session, method, parameters)
                .orTimeout(PATIENCE_SECONDS, TimeUnit.SECONDS)
                .join();
    }

    private void noteDownload(String event, JsonObject parameters) {
        if (event.equals("Browser.downloadWillBegin")) {
            downloadName = parameters.get("suggestedFilename").getAsString();
        } else if (event.equals("Browser.downloadProgress")
                && parameters.get("state").getAsString().equals("completed")) {
            downloaded.complete(downloadName);
        }
    }

    private void receiveEvent(JsonObject message) {
        noteDownload(message.get("method").getAsString(), message.getAsJsonObject("params"));
        if (!message.has("sessionId") || !message.get("sessionId").getAsString().equals(session)) {
            return;
        }
        JsonObject parameters = message.getAsJsonObject("params");
        switch (message.get("method").getAsString()) {
            case "Runtime.exceptionThrown" ->
                complaints.add(parameters.get("exceptionDetails").toString());
            case "Page.javascriptDialogOpening" -> agree();
            case "Runtime.consoleAPICalled" -> noteConsole(parameters);
            case "Log.entryAdded" -> noteLog(parameters.getAsJsonObject("entry"));
            case "Network.requestWillBeSent" ->
                noteRequest(parameters.getAsJsonObject("request").get("url").getAsString());
            default -> {}
        }
    }

    /** Confirms the question about unsaved work when a test leaves the page. */
    private void agree() {
        JsonObject parameters = new JsonObject();
        parameters.addProperty("accept", true);
        Thread answer = new Thread(() -> call("Page.handleJavaScriptDialog", parameters), "chromium-dialog");
        answer.setDaemon(true);
        answer.start();
    }

    private void noteConsole(JsonObject parameters) {
        if (List.of("error", "warning", "assert")
                .contains(parameters.get("type").getAsString())) {
            complaints.add(parameters.get("args").toString());
        }
    }

    private void noteLog(JsonObject entry) {
        String wording = entry.get("text").getAsString();
        boolean expected = wording.contains("GPU stall due to ReadPixels");
        if (!entry.get("level").getAsString().equals("info") && !expected) {
            complaints.add(wording);
        }
    }

    private void noteRequest(String address) {
        if (!address.matches("(http://127\\.0\\.0\\.1:|file:|data:|blob:|about:).*")) {
            complaints.add("asked for " + address);
        }
    }

    /** Returns the CPU time of the browser with all its processes. */
    double processorSeconds() {
        return process.processorSeconds();
    }

    @Override
    public void close() {
        process.close();
    }
}
