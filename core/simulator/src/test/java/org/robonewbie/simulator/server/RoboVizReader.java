package org.robonewbie.simulator.server;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;

/**
 * Reads monitor messages as RoboViz does: three lists, of which the first one has at least one list within; nodes of changes are
 * counted off against those of the last full message; everything that it could not bear is a failure.
 */
final class RoboVizReader {

    private static final int KNOWN_FOULS = 11;

    private final Map<String, List<String>> values = new HashMap<>();
    private final List<List<String>> fouls = new ArrayList<>();
    private Node scene = new Node("");
    private int fullMessages;

    /** A list of the message: its words and the lists within, each in their order. */
    static final class Node {

        final String name;
        final List<String> words = new ArrayList<>();
        final List<Node> children = new ArrayList<>();

        Node(String name) {
            this.name = name;
        }

        boolean isTransform() {
            return name.equals("nd") && !words.isEmpty() && words.get(0).equals("TRF");
        }

        List<Node> nodes() {
            return children.stream().filter(child -> child.name.equals("nd")).toList();
        }
    }

    void read(String text) {
        List<Node> lists = parse(text);
        check(lists.size() == 3, "three lists", text);
        check(!lists.get(0).children.isEmpty(), "a first list with something in it", text);
        lists.get(0).children.forEach(this::readValue);
        check(lists.get(1).words.equals(List.of("0", "1")), "version 0 1", text);
        switch (lists.get(1).name) {
            case "RSG" -> {
                lists.get(2).nodes().forEach(RoboVizReader::checkFull);
                scene = lists.get(2);
                fullMessages++;
            }
            case "RDS" -> checkChanges(scene, lists.get(2));
            default -> throw new AssertionError("Neither RSG nor RDS: " + text);
        }
    }

    List<Node> nodes() {
        return scene.nodes();
    }

    int fullMessages() {
        return fullMessages;
    }

    List<List<String>> fouls() {
        return fouls;
    }

    String value(String name) {
        return String.join(" ", values.getOrDefault(name, List.of()));
    }

    private void readValue(Node value) {
        values.put(value.name, value.words);
        switch (value.name) {
            case "play_mode" -> {
                int index = Integer.parseInt(value.words.get(0));
                check(index < values.getOrDefault("play_modes", List.of()).size(), "a known play mode", value.name);
            }
            case "half", "score_left", "score_right" -> Integer.parseInt(value.words.get(0));
            case "foul" -> {
                check(value.words.size() == 4, "a foul with four numbers", value.words.toString());
                check(Integer.parseInt(value.words.get(1)) < KNOWN_FOULS, "a known foul", value.words.toString());
                fouls.add(value.words);
            }
            case "team_left", "team_right", "play_modes" -> check(!value.words.isEmpty(), "a name", value.name);
            default -> Double.parseDouble(value.words.get(0));
        }
    }

    private static void checkFull(Node node) {
        check(!node.words.isEmpty(), "a kind of node", node.name);
        check(
                List.of("TRF", "Light", "StaticMesh", "SMN").contains(node.words.get(0)),
                "a known node",
                node.words.get(0));
        if (node.isTransform()) {
            check(node.children.get(0).name.equals("SLT"), "SLT as the first child", node.children.get(0).name);
            check(
                    node.children.get(0).words.size() == 16,
                    "16 numbers",
                    node.children.get(0).words.toString());
        }
        node.nodes().forEach(RoboVizReader::checkFull);
    }

    private static void checkChanges(Node full, Node changes) {
        List<Node> before = full.nodes();
        List<Node> now = changes.nodes();
        check(before.size() == now.size(), before.size() + " nodes", now.size() + " nodes");
        for (int i = 0; i < now.size(); i++) {
            List<String> names =
                    now.get(i).children.stream().map(child -> child.name).toList();
            check(names.lastIndexOf("SLT") <= 0, "SLT first", names.toString());
            checkChanges(before.get(i), now.get(i));
        }
    }

    private static void check(boolean holds, String wanted, String found) {
        if (!holds) {
            throw new AssertionError("RoboViz needs " + wanted + ", but found " + found);
        }
    }

    private static List<Node> parse(String text) {
        Node outermost = new Node("");
        List<Node> open = new ArrayList<>(List.of(outermost));
        String spaced = text.replace("(", " ( ").replace(")", " ) ").trim();
        String[] tokens = spaced.split("\\s+", -1);
        for (int i = 0; i < tokens.length; i++) {
            Node current = open.get(open.size() - 1);
            if (tokens[i].equals("(")) {
                boolean isNamed = !tokens[i + 1].equals("(") && !tokens[i + 1].equals(")");
                Node child = new Node(isNamed ? tokens[i + 1] : "");
                i += isNamed ? 1 : 0;
                current.children.add(child);
                open.add(child);
            } else if (tokens[i].equals(")")) {
                open.remove(open.size() - 1);
            } else {
                current.words.add(tokens[i]);
            }
        }
        return outermost.children;
    }
}
