package org.robonewbie.studio;

import com.google.gson.JsonArray;
import com.google.gson.JsonElement;
import com.google.gson.JsonObject;
import com.google.gson.JsonParser;
import com.google.gson.JsonPrimitive;
import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStreamReader;
import java.io.Writer;
import java.net.URI;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.concurrent.CompletionException;
import java.util.concurrent.TimeUnit;

/** A headless Firefox without WebGL, controlled by WebDriver BiDi. A later browser can use the same profile. */
final class Firefox implements AnyBrowser, AutoCloseable {

    static final Tool TOOL = new Tool("Firefox", List.of("firefox-esr", "firefox"));

    private static final String ANNOUNCEMENT = "WebDriver BiDi listening on ";
    private static final int PATIENCE_SECONDS = 120;

    /** The Control key in WebDriver's encoding. */
    private final Process process;

    private final DevTools tools;
    private final String context;

    private Firefox(Process process, URI address) {
        this.process = process;
        this.tools = new DevTools(address, event -> {});
        JsonObject wishes = new JsonObject();
        wishes.add("capabilities", new JsonObject());
        call("session.new", wishes);
        JsonObject kind = new JsonObject();
        kind.addProperty("type", "tab");
        context = call("browsingContext.create", kind).get("context").getAsString();
    }

    /**
     * Starts the browser for a user who is no newcomer.
     *
     * @param profile an empty folder, or that of a closed browser
     * @param preferences lines of its file {@code user.js}
     */
    static Firefox start(Path profile, String... preferences) throws IOException {
        Files.write(profile.resolve("user.js"), List.of(preferences));
        Process process = new ProcessBuilder(
                        TOOL.orSkip().toString(),
                        "--headless",
                        "--no-remote",
                        "--remote-debugging-port=0",
                        "--profile",
                        profile.toString())
                .redirectErrorStream(true)
                .start();
        BufferedReader output =
                new BufferedReader(new InputStreamReader(process.getInputStream(), StandardCharsets.UTF_8));
        for (String line = output.readLine(); line != null; line = output.readLine()) {
            if (line.contains(ANNOUNCEMENT)) {
                drain(output);
                String address = line.substring(line.indexOf(ANNOUNCEMENT) + ANNOUNCEMENT.length());
                Firefox firefox = new Firefox(process, URI.create(address.strip() + "/session"));
                firefox.runBeforePages(BrowserForTests.SKIP_FIRST_MINUTE);
                return firefox;
            }
        }
        throw new IOException("Firefox did not start.");
    }

    private static void drain(BufferedReader output) {
        Thread reader = new Thread(
                () -> {
                    try {
                        output.transferTo(Writer.nullWriter());
                    } catch (IOException browserIsClosed) {
                        return;
                    }
                },
                "firefox-output");
        reader.setDaemon(true);
        reader.start();
    }

    private void runBeforePages(String statement) {
        JsonObject script = new JsonObject();
        script.addProperty("functionDeclaration", "() => { " + statement + " }");
        call("script.addPreloadScript", script);
    }

    /** Opens an address and waits until the page has loaded. */
    @Override
    public void visit(String address) {
        JsonObject place = new JsonObject();
        place.addProperty("context", context);
        place.addProperty("url", address);
        place.addProperty("wait", "complete");
        call("browsingContext.navigate", place);
    }

    /** Evaluates a JavaScript expression in the page. */
    @Override
    public JsonElement evaluate(String expression) {
        JsonObject target = new JsonObject();
        target.addProperty("context", context);
        JsonObject parameters = new JsonObject();
        parameters.addProperty(
                "expression", "Promise.resolve(" + expression + ").then((value) => JSON.stringify(value ?? null))");
        parameters.add("target", target);
        parameters.addProperty("awaitPromise", true);
        JsonObject answer = call("script.evaluate", parameters);
        if (!answer.get("type").getAsString().equals("success")) {
            throw new AssertionError(expression + " failed: " + answer);
        }
        return JsonParser.parseString(
                answer.getAsJsonObject("result").get("value").getAsString());
    }

    /** Waits until a JavaScript condition holds in the page, which polls it and answers once it does. */
    @Override
    public void await(String condition) {
        try {
            evaluate("new Promise((answer) => { const look = () => { let holds = false; try { holds = " + condition
                    + "; } catch { holds = false; } if (holds) { answer(true); } else { setTimeout(look, 15); } };"
                    + " look(); })");
        } catch (CompletionException tooLate) {
            throw new AssertionError(
                    "Not within " + PATIENCE_SECONDS + " s: " + condition + "; the page shows "
                            + evaluate("document.body.innerText"),
                    tooLate);
        }
    }

    /** Clicks as soon as the element exists and is enabled. */
    @Override
    public void click(String selector) {
        await("(() => { const found = document.querySelector(" + new JsonPrimitive(selector)
                + "); const ready = found && !found.disabled; if (ready) { found.click(); } return ready; })()");
    }

    /** Types into the focused element, key by key. */
    void type(String text) {
        JsonArray keys = new JsonArray();
        for (int i = 0; i < text.length(); i++) {
            keys.add(key("keyDown", text.substring(i, i + 1)));
            keys.add(key("keyUp", text.substring(i, i + 1)));
        }
        perform(keys);
    }

    private static JsonObject key(String kind, String value) {
        JsonObject key = new JsonObject();
        key.addProperty("type", kind);
        key.addProperty("value", value);
        return key;
    }

    private void perform(JsonArray keys) {
        JsonObject keyboard = new JsonObject();
        keyboard.addProperty("type", "key");
        keyboard.addProperty("id", "keyboard");
        keyboard.add("actions", keys);
        JsonArray sources = new JsonArray();
        sources.add(keyboard);
        JsonObject parameters = new JsonObject();
        parameters.addProperty("context", context);
        parameters.add("actions", sources);
        call("input.performActions", parameters);
    }

    private JsonObject call(String method, JsonObject parameters) {
        return tools.send("", method, parameters)
                .orTimeout(PATIENCE_SECONDS, TimeUnit.SECONDS)
                .join();
    }

    /** Quits the browser regularly, so that it stores the data of pages. */
    @Override
    public void close() {
        call("browser.close", new JsonObject());
        try {
            if (!process.waitFor(PATIENCE_SECONDS, TimeUnit.SECONDS)) {
                process.destroyForcibly();
            }
        } catch (InterruptedException stopped) {
            process.destroyForcibly();
            Thread.currentThread().interrupt();
        }
    }
}
