package org.robonewbie.protocol.monitor;

import java.util.ArrayList;
import java.util.List;
import org.robonewbie.protocol.monitor.LightNode.Colour;
import org.robonewbie.protocol.sexp.SexpReader;
import org.robonewbie.protocol.sexp.Token;

/** Parses the scene of a monitor message. Each method starts after the opening parenthesis of its list. */
final class SceneReader {

    /** Maximum accepted nesting depth; the soccer scene has four levels. */
    private static final int MAX_DEPTH = 64;

    private final SexpReader in;

    SceneReader(SexpReader in) {
        this.in = in;
    }

    /** Parses the scene of a full message. */
    List<SceneNode> readFull() throws MalformedMessageException {
        List<SceneNode> nodes = new ArrayList<>();
        int inside = in.depth();
        while (in.nextList(inside)) {
            require(in.atomIs("nd"));
            nodes.add(readNode());
        }
        requireEnd();
        return List.copyOf(nodes);
    }

    /** Parses the changes in a partial message and applies them to a scene. */
    void readPartial(List<SceneNode> nodes) throws MalformedMessageException {
        int count = 0;
        int inside = in.depth();
        while (in.nextList(inside)) {
            require(in.atomIs("nd"));
            applyToChild(nodes, count++);
        }
        requireEnd();
        require(count == nodes.size());
    }

    private SceneNode readNode() throws MalformedMessageException {
        require(in.depth() < MAX_DEPTH && in.next() == Token.ATOM);
        if (in.atomIs("Light")) {
            return readLight();
        }
        if (in.atomIs("StaticMesh") || in.atomIs("SMN")) {
            return readMesh(in.atomIs("SMN"));
        }
        return readTransform();
    }

    private TransformNode readTransform() throws MalformedMessageException {
        TransformNode transform = TransformNode.at(0, 0, 0);
        List<SceneNode> children = new ArrayList<>();
        int inside = in.depth();
        while (in.nextList(inside)) {
            if (in.atomIs("nd")) {
                children.add(readNode());
            } else if (in.atomIs("SLT")) {
                transform.moveTo(readNumbers(16), 0);
            }
        }
        requireEnd();
        return transform.with(children);
    }

    private MeshNode readMesh(boolean standardShape) throws MalformedMessageException {
        boolean visible = false;
        boolean transparent = false;
        float[] scale = {1, 1, 1};
        List<String> load = List.of();
        List<String> materials = List.of();
        int inside = in.depth();
        while (in.nextList(inside)) {
            if (in.atomIs("setVisible")) {
                visible = readNumbers(1)[0] != 0;
            } else if (in.atomIs("setTransparent")) {
                transparent = true;
            } else if (in.atomIs("load")) {
                load = readWords();
            } else if (in.atomIs("sSc")) {
                scale = readNumbers(3);
            } else if (in.atomIs("resetMaterials") || in.atomIs("sMat")) {
                materials = readWords();
            }
        }
        requireEnd();
        String name = load.isEmpty() ? "" : load.get(0);
        List<String> parameters = load.isEmpty() ? load : load.subList(1, load.size());
        MeshNode.Form form =
                standardShape ? new MeshNode.StandardShape(name, parameters) : new MeshNode.MeshFile(name, parameters);
        return new MeshNode(form, scale[0], scale[1], scale[2], materials, transparent, visible);
    }

    private LightNode readLight() throws MalformedMessageException {
        Colour diffuse = Colour.grey(1);
        Colour ambient = Colour.grey(0);
        Colour specular = Colour.grey(0);
        int inside = in.depth();
        while (in.nextList(inside)) {
            if (in.atomIs("setDiffuse")) {
                diffuse = readColour();
            } else if (in.atomIs("setAmbient")) {
                ambient = readColour();
            } else if (in.atomIs("setSpecular")) {
                specular = readColour();
            }
        }
        requireEnd();
        return new LightNode(diffuse, ambient, specular);
    }

    private void applyToChild(List<SceneNode> nodes, int index) throws MalformedMessageException {
        require(index < nodes.size());
        SceneNode node = nodes.get(index);
        if (node instanceof TransformNode transform) {
            applyTo(transform);
        } else if (node instanceof MeshNode mesh) {
            applyTo(mesh);
        } else {
            in.skipTo(in.depth() - 1);
        }
    }

    private void applyTo(TransformNode transform) throws MalformedMessageException {
        int count = 0;
        int inside = in.depth();
        while (in.nextList(inside)) {
            if (in.atomIs("nd")) {
                applyToChild(transform.children(), count++);
            } else if (in.atomIs("SLT")) {
                transform.moveTo(readNumbers(16), 0);
            }
        }
        requireEnd();
        require(count == transform.children().size());
    }

    private void applyTo(MeshNode mesh) throws MalformedMessageException {
        int inside = in.depth();
        while (in.nextList(inside)) {
            require(!in.atomIs("nd"));
            if (in.atomIs("setVisible")) {
                mesh.setVisible(readNumbers(1)[0] != 0);
            }
        }
        requireEnd();
    }

    private Colour readColour() throws MalformedMessageException {
        float[] parts = readNumbers(4);
        return new Colour(parts[0], parts[1], parts[2], parts[3]);
    }

    private void requireEnd() throws MalformedMessageException {
        require(in.token() == Token.CLOSE);
    }

    private List<String> readWords() {
        List<String> words = new ArrayList<>();
        while (in.next() == Token.ATOM) {
            words.add(in.text());
        }
        return List.copyOf(words);
    }

    /** Reads the next {@code count} words as numbers. Any word that is not a finite number counts as 0. */
    private float[] readNumbers(int count) throws MalformedMessageException {
        float[] numbers = new float[count];
        for (int i = 0; i < count; i++) {
            require(in.next() == Token.ATOM);
            float number = (float) in.number();
            numbers[i] = Float.isFinite(number) ? number : 0;
        }
        return numbers;
    }

    static void require(boolean condition) throws MalformedMessageException {
        if (!condition) {
            throw new MalformedMessageException();
        }
    }
}
