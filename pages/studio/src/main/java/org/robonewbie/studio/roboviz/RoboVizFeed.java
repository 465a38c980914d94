package org.robonewbie.studio.roboviz;

import com.google.gson.JsonArray;
import com.google.gson.JsonObject;
import java.util.ArrayList;
import java.util.Collection;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import org.robonewbie.simulator.json.Json;

/**
 * Teams' drawings in RoboViz's model: double-buffered sets of shapes. Shapes go to the back buffer and appear at the next swap of
 * their set. A swap clears the new back buffer, so a swap without shapes erases the set. Thread-safe.
 */
public final class RoboVizFeed {

    /** Name of the set of labels above robots, which are shown without a swap. */
    static final String AGENT_TEXTS = "texts above robots";

    private static final int MAX_SETS = 300;
    private static final int MAX_SHAPES = 2000;

    private final Map<String, List<RoboVizCommand.Draw>> hidden = new LinkedHashMap<>();
    private final Map<String, Sheet> shown = new TreeMap<>();
    private final Map<String, RoboVizCommand.AgentText> agentTexts = new TreeMap<>();
    private int revision;

    /** Front buffer of a set, and the revision of its last change. */
    private record Sheet(int revision, JsonArray shapes) {}

    /** Creates an empty feed. */
    public RoboVizFeed() {}

    synchronized void execute(Collection<RoboVizCommand> commands) {
        commands.forEach(this::execute);
    }

    private void execute(RoboVizCommand command) {
        if (command instanceof RoboVizCommand.Draw draw) {
            draw(draw);
        } else if (command instanceof RoboVizCommand.Swap swap) {
            swap(swap.prefix());
        } else if (command instanceof RoboVizCommand.AgentText text) {
            write(text);
        }
    }

    private void draw(RoboVizCommand.Draw draw) {
        List<RoboVizCommand.Draw> shapes = hidden.get(draw.set());
        if (shapes == null && hidden.size() < MAX_SETS) {
            shapes = new ArrayList<>();
            hidden.put(draw.set(), shapes);
        }
        if (shapes != null && shapes.size() < MAX_SHAPES) {
            shapes.add(draw);
        }
    }

    private void swap(String prefix) {
        revision++;
        hidden.forEach((set, shapes) -> {
            if (set.startsWith(prefix)) {
                JsonArray sheet = new JsonArray();
                shapes.forEach(shape -> sheet.add(json(shape)));
                shown.put(set, new Sheet(revision, sheet));
                shapes.clear();
            }
        });
    }

    private void write(RoboVizCommand.AgentText text) {
        revision++;
        String robot = text.side() + " " + text.number();
        if (text.text().isEmpty()) {
            agentTexts.remove(robot);
        } else {
            agentTexts.put(robot, text);
        }
        JsonArray sheet = Json.array(agentTexts.values().stream().map(RoboVizFeed::json));
        shown.put(AGENT_TEXTS, new Sheet(revision, sheet));
    }

    private static JsonObject json(RoboVizCommand.Draw draw) {
        return Json.object(
                "shape", draw.shape(),
                "numbers", draw.numbers(),
                "colour", draw.colour(),
                "opacity", draw.opacity(),
                "text", draw.text());
    }

    private static JsonObject json(RoboVizCommand.AgentText text) {
        return Json.object(
                "shape", "agent",
                "side", text.side().name().toLowerCase(Locale.ROOT),
                "number", text.number(),
                "colour", text.colour(),
                "text", text.text());
    }

    /** {@return the number of changes so far} */
    public synchronized int revision() {
        return revision;
    }

    /**
     * Returns the sets that have changed since a revision.
     *
     * @param known the last revision that a page has received, 0 for none
     * @return one JSON object; empty if nothing has changed
     */
    public synchronized Optional<String> since(int known) {
        JsonObject sets = new JsonObject();
        shown.forEach((set, sheet) -> {
            if (sheet.revision() > known) {
                sets.add(set, sheet.shapes());
            }
        });
        if (sets.isEmpty()) {
            return Optional.empty();
        }
        return Optional.of(Json.object("kind", "board", "sets", sets).toString());
    }
}
