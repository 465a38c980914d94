package org.robonewbie.protocol.monitor;

import java.util.List;
import java.util.Optional;
import org.robonewbie.nao.Vector3;
import org.robonewbie.nao.kinematics.Pose;
import org.robonewbie.nao.kinematics.Rotation;
import org.robonewbie.protocol.sexp.SexpReader;
import org.robonewbie.protocol.sexp.Token;

/**
 * Parses the scene graph of an RSMP message. Each method starts after the name of its list and ends with the closing parenthesis of
 * that list.
 */
final class RsmpSceneReader {

    /** Maximum accepted nesting depth; a match of T1s has 20 levels. */
    private static final int MAX_DEPTH = 64;

    /** Maximum accepted number of nodes; a T1 has 100. */
    private static final int MAX_NODES = 20_000;

    private static final int MAX_DESCRIPTIONS = 8;
    private static final int MATRIX_ELEMENTS = 16;

    /** Tolerance of matrices with four decimals. */
    private static final double TOLERANCE = 0.01;

    private final SexpReader in;
    private final RsmpWords words;
    private final double[] matrix = new double[MATRIX_ELEMENTS];
    private int nodes;

    RsmpSceneReader(SexpReader in, RsmpWords words) {
        this.in = in;
        this.words = words;
    }

    /** Parses a full scene, from its root's opening parenthesis on. */
    RsmpNode readFull() throws MalformedMessageException {
        nodes = 0;
        openRoot();
        return readNode();
    }

    /** Parses changes, from their root's opening parenthesis on, and applies them to a scene. */
    void readChanges(RsmpNode root) throws MalformedMessageException {
        openRoot();
        applyTo(root);
    }

    private void openRoot() throws MalformedMessageException {
        words.open();
        if (in.next() != Token.ATOM || !in.atomIs("nd")) {
            throw words.unexpected("\"nd\"");
        }
    }

    private RsmpNode readNode() throws MalformedMessageException {
        requireRoom();
        nodes++;
        if (nodes > MAX_NODES) {
            throw new MalformedMessageException("the scene has more than " + MAX_NODES + " nodes");
        }
        RsmpNode node = new RsmpNode();
        Token kind = in.next();
        if (kind == Token.ATOM && in.atomIs("SMN")) {
            node.draw(readMesh());
        } else if (kind == Token.ATOM && in.atomIs("DSC")) {
            readDescription(node);
        } else if (kind == Token.ATOM && in.atomIs("TRF")) {
            readTransform(node);
        } else {
            throw words.unexpected("\"DSC\", \"TRF\" or \"SMN\"");
        }
        return node;
    }

    private void readDescription(RsmpNode node) throws MalformedMessageException {
        while (nextList()) {
            if (in.atomIs("nd")) {
                node.add(readNode());
                continue;
            }
            if (node.descriptions().size() == MAX_DESCRIPTIONS) {
                throw new MalformedMessageException(
                        "a node has more than " + MAX_DESCRIPTIONS + " descriptions, from " + words.quoted() + " on");
            }
            node.describe(words.list());
        }
    }

    private void readTransform(RsmpNode node) throws MalformedMessageException {
        while (nextList()) {
            if (in.atomIs("nd")) {
                node.add(readNode());
            } else {
                node.moveTo(readPose());
            }
        }
        if (!node.isTransform()) {
            throw new MalformedMessageException("a node \"TRF\" has no \"SLT\"");
        }
    }

    private MeshNode readMesh() throws MalformedMessageException {
        boolean visible = true;
        float[] scale = {1, 1, 1};
        Optional<String> load = Optional.empty();
        List<String> materials = List.of();
        int inside = in.depth();
        while (nextList()) {
            switch (words.text()) {
                case "setVisible" -> visible = words.integer("whether a shape is visible", 0, 1) == 1;
                case "load" -> load = Optional.of(words.word("the name of a shape"));
                case "sSc" -> {
                    for (int i = 0; i < scale.length; i++) {
                        scale[i] = (float) words.number("a scale");
                    }
                }
                case "sMat" -> materials = List.of(words.word("the name of a material"));
                default -> {} // colours
            }
            in.skipTo(inside);
        }
        String name = load.orElseThrow(() -> new MalformedMessageException("a node \"SMN\" has no \"load\""));
        MeshNode.Form form = name.startsWith("Std")
                ? new MeshNode.StandardShape(name, List.of())
                : new MeshNode.MeshFile(name, List.of());
        return new MeshNode(form, scale[0], scale[1], scale[2], materials, false, visible);
    }

    private void applyTo(RsmpNode node) throws MalformedMessageException {
        requireRoom();
        Token token = in.next();
        if (token == Token.ATOM) {
            if (!in.atomIs("TRF") || !node.isTransform()) {
                throw words.unexpected("changes of the scene that was sent before");
            }
            token = in.next();
        }
        int count = 0;
        for (; token == Token.OPEN; token = in.next()) {
            if (in.next() != Token.ATOM || !(in.atomIs("nd") || node.isTransform())) {
                throw words.unexpected("\"nd\"");
            }
            if (!in.atomIs("nd")) {
                node.moveTo(readPose());
            } else if (count < node.children().size()) {
                applyTo(node.children().get(count++));
            } else {
                throw new MalformedMessageException("the changes have more than the " + count
                        + " nodes that were sent before, from " + words.quoted() + " on");
            }
        }
        if (token != Token.CLOSE) {
            throw words.unexpected("\")\"");
        }
        if (count != node.children().size()) {
            throw new MalformedMessageException("the changes have " + count + " \"nd\" where the scene has "
                    + node.children().size());
        }
    }

    private Pose readPose() throws MalformedMessageException {
        if (!in.atomIs("SLT")) {
            throw words.unexpected("\"SLT\" or \"nd\"");
        }
        for (int i = 0; i < matrix.length; i++) {
            matrix[i] = words.number("element " + (i + 1) + " of 16 of \"SLT\"");
        }
        words.close();
        double[] m = matrix;
        if (!isRotation(m)) {
            throw new MalformedMessageException("the first elements of \"SLT\" are no rotation");
        }
        return new Pose(
                new Vector3(m[12], m[13], m[14]),
                Rotation.ofMatrix(m[0], m[4], m[8], m[1], m[5], m[9], m[2], m[6], m[10]));
    }

    /** Returns whether the columns of a matrix are of length 1, at right angles, and right-handed. */
    private static boolean isRotation(double[] m) {
        Vector3 x = new Vector3(m[0], m[1], m[2]);
        Vector3 y = new Vector3(m[4], m[5], m[6]);
        Vector3 z = new Vector3(m[8], m[9], m[10]);
        return Math.abs(x.length() - 1) < TOLERANCE
                && Math.abs(y.length() - 1) < TOLERANCE
                && x.cross(y).minus(z).length() < TOLERANCE;
    }

    /** Advances to the name of the next list; returns false at the end of the enclosing list. */
    private boolean nextList() throws MalformedMessageException {
        Token token = in.next();
        if (token == Token.CLOSE) {
            return false;
        }
        if (token != Token.OPEN) {
            throw words.unexpected("\"(\" or \")\"");
        }
        if (in.next() != Token.ATOM) {
            throw words.unexpected("the name of a list");
        }
        return true;
    }

    private void requireRoom() throws MalformedMessageException {
        if (in.depth() > MAX_DEPTH) {
            throw new MalformedMessageException("nodes are nested deeper than " + MAX_DEPTH + " levels");
        }
    }
}
