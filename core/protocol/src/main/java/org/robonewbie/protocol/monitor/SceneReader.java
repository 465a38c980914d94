package org.robonewbie.protocol.monitor;

import java.util.ArrayList;
import java.util.List;
import org.robonewbie.protocol.monitor.LightNode.Colour;
import org.robonewbie.protocol.sexp.SexpReader;
import org.robonewbie.protocol.sexp.Token;

/** Reads the scene of a monitor message; each method starts just after the opening parenthesis of the list that it reads. */
final class SceneReader {

    /** The soccer scene is four levels deep; anything deeper than this is an attack. */
    private static final int MAX_DEPTH = 64;

    private final SexpReader in;

    SceneReader(SexpReader in) {
        this.in = in;
    }

    /** Reads a whole scene. */
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

    /** Reads changes into a known scene. */
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
            return new MeshReader(in).read(in.atomIs("SMN"));
        }
        return readTransform();
    }

    private TransformNode readTransform() throws MalformedMessageException {
        TransformNode place = TransformNode.at(0, 0, 0);
        List<SceneNode> children = new ArrayList<>();
        int inside = in.depth();
        while (in.nextList(inside)) {
            if (in.atomIs("nd")) {
                children.add(readNode());
            } else if (in.atomIs("SLT")) {
                readPlace(place);
            }
        }
        requireEnd();
        return place.with(children);
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
                readPlace(transform);
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
                mesh.setVisible(readNumbers(in, 1)[0] != 0);
            }
        }
        requireEnd();
    }

    private void readPlace(TransformNode transform) throws MalformedMessageException {
        transform.moveTo(readNumbers(in, 16), 0);
    }

    private Colour readColour() throws MalformedMessageException {
        float[] parts = readNumbers(in, 4);
        return new Colour(parts[0], parts[1], parts[2], parts[3]);
    }

    private void requireEnd() throws MalformedMessageException {
        require(in.token() == Token.CLOSE);
    }

    /** Reads the first numbers of a list; anything that is not a finite number counts as 0. */
    static float[] readNumbers(SexpReader in, int count) throws MalformedMessageException {
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
