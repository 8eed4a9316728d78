"""Makes the page of the lab: make_page.py FOLDER_OF_THE_PROGRAM DIST [NAME=LICENCE…]

DIST/web is a folder for any web server. DIST/braitenlab-web.html is a single file that needs none: it contains the
program and its data, compressed.
"""

import base64
import gzip
import hashlib
import json
import pathlib
import shutil
import sys

here = pathlib.Path(__file__).parent
built, dist = pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2])
names = ["braitenlab.wasm", "braitenlab.data", "braitenlab.js"]
contents = {name: (built / name).read_bytes() for name in names}
version = hashlib.sha256(b"".join(contents.values())).hexdigest()[:16]
icon = base64.b64encode((here.parent / "icons" / "braitenlab.svg").read_bytes()).decode()
facts = {"version": version, "sizes": {name: len(content) for name, content in contents.items()}}
scripts = [(here / name).read_text(encoding="utf-8") for name in ("files.js", "typing.js", "graphics.js", "page.js")]
script = "\n".join([f"const built = {json.dumps(facts)};", *scripts])


def page(files):
    text = (here / "page.html").read_text(encoding="utf-8")
    for name, value in {"ICON": icon, "FILES": files, "SCRIPT": script}.items():
        text = text.replace(f"@{name}@", value)
    return text


def embedded(name):
    packed = base64.b64encode(gzip.compress(contents[name], 9, mtime=0)).decode()
    return f'<script type="text/plain" id="{name}">{packed}</script>'


folder = dist / "web"
shutil.rmtree(folder, ignore_errors=True)
folder.mkdir(parents=True)
for name in names:
    (folder / name).write_bytes(contents[name])
(folder / "index.html").write_text(page(""), encoding="utf-8")
for name, licence in (pair.split("=", 1) for pair in sys.argv[3:]):
    (folder / "licences").mkdir(exist_ok=True)
    shutil.copyfile(licence, folder / "licences" / f"{name}.txt")
(dist / "braitenlab-web.html").write_text(page("\n".join(map(embedded, names))), encoding="utf-8")

compressed = sum(len(gzip.compress((folder / name).read_bytes(), 9)) for name in [*names, "index.html"])
print(f"{folder}: {compressed / 1e6:.2f} MB compressed")
