package org.robonewbie.protocol.monitor;

import java.util.ArrayList;
import java.util.List;
import org.robonewbie.protocol.sexp.SexpReader;
import org.robonewbie.protocol.sexp.Token;

/** Reads one surface of a scene. */
final class MeshReader {

    private final SexpReader in;
    private boolean visible;
    private boolean transparent;
    private float[] scale = {1, 1, 1};
    private List<String> load = List.of("");
    private List<String> materials = List.of();

    MeshReader(SexpReader in) {
        this.in = in;
    }

    /** Reads the rest of a mesh whose kind has just been read. */
    MeshNode read(boolean standardShape) throws MalformedMessageException {
        int inside = in.depth();
        while (in.nextList(inside)) {
            readProperty();
        }
        SceneReader.require(in.token() == Token.CLOSE);
        String name = load.isEmpty() ? "" : load.get(0);
        List<String> parameters = load.size() < 2 ? List.of() : load.subList(1, load.size());
        MeshNode.Form form =
                standardShape ? new MeshNode.StandardShape(name, parameters) : new MeshNode.MeshFile(name, parameters);
        return new MeshNode(form, scale[0], scale[1], scale[2], materials, transparent, visible);
    }

    private void readProperty() throws MalformedMessageException {
        if (in.atomIs("setVisible")) {
            visible = SceneReader.readNumbers(in, 1)[0] != 0;
        } else if (in.atomIs("setTransparent")) {
            transparent = true;
        } else if (in.atomIs("load")) {
            load = readWords();
        } else if (in.atomIs("sSc")) {
            scale = SceneReader.readNumbers(in, 3);
        } else if (in.atomIs("resetMaterials") || in.atomIs("sMat")) {
            materials = readWords();
        }
    }

    private List<String> readWords() {
        List<String> words = new ArrayList<>();
        while (in.next() == Token.ATOM) {
            words.add(in.text());
        }
        return List.copyOf(words);
    }
}
