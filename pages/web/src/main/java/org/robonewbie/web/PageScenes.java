package org.robonewbie.web;

import com.google.gson.JsonObject;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.TreeMap;
import org.robonewbie.simulator.json.Json;
import org.robonewbie.studio.PageFeed;
import org.robonewbie.studio.scene.SavedScene;
import org.robonewbie.studio.scene.SceneStore;

/**
 * Scenes in the page. Each request contains the names of the scenes stored by the browser, and the contents of those to which it refers.
 * The page receives changes as messages and stores them.
 */
final class PageScenes implements SceneStore {

    /** Contents of the scenes by name, with one character per byte; empty until they are needed. */
    private final TreeMap<String, String> scenes = new TreeMap<>();

    /** Handles a request; returns JSON, or a sentence if the request is rejected. */
    String answer(ServiceRequest request, PageFeed feed) {
        JsonObject stored = request.json().getAsJsonObject("scenes");
        scenes.keySet().retainAll(stored.keySet());
        stored.entrySet()
                .forEach(each -> scenes.merge(
                        each.getKey(), each.getValue().getAsString(), (old, given) -> given.isEmpty() ? old : given));
        return request.answer(feed.scenes(this));
    }

    @Override
    public List<String> names() {
        return List.copyOf(scenes.keySet());
    }

    @Override
    public SavedScene read(String name) {
        return SavedScene.of(scenes.getOrDefault(name, "").getBytes(StandardCharsets.ISO_8859_1));
    }

    @Override
    public void write(String name, SavedScene scene) {
        String text = new String(scene.toBytes(), StandardCharsets.ISO_8859_1);
        scenes.put(name, text);
        PageContext.post("scene", Json.object("name", name, "text", text).toString());
    }

    @Override
    public void delete(String name) {
        scenes.remove(name);
        PageContext.post("scene", Json.object("name", name).toString());
    }
}
