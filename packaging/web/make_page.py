"""Makes the page of the lab: make_page.py FOLDER_OF_THE_PROGRAM DIST [NAME=LICENCE…]

DIST/web is a folder for any web server: the page unpacks the compressed files itself. DIST/braitenlab-web.html is a
single file that needs none: it contains the program and its data, compressed.
"""

import base64
import gzip
import hashlib
import json
import pathlib
import re
import shutil
import sys

here = pathlib.Path(__file__).parent
built, dist = pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2])
names = ["braitenlab.wasm", "braitenlab.data", "braitenlab.js"]
packed = {name: gzip.compress((built / name).read_bytes(), 9, mtime=0) for name in names}
version = hashlib.sha256(b"".join(packed.values())).hexdigest()[:16]
icon = base64.b64encode((here.parent / "icons" / "braitenlab.svg").read_bytes()).decode()
facts = {
    "version": version,
    "sizes": {name: len(content) for name, content in packed.items()},
    "unpacked": {name: (built / name).stat().st_size for name in names},
}
sources = ["storage.js", "files.js", "typing.js", "graphics.js", "page.js"]
# A server may send the page as it is: without comments and indentation it is a fifth smaller.
scripts = [re.sub(r"^ *(//.*\n)?", "", (here / name).read_text(encoding="utf-8"), flags=re.MULTILINE) for name in sources]
script = "\n".join([f"const built = {json.dumps(facts)};", *scripts])


def page(files):
    text = (here / "page.html").read_text(encoding="utf-8")
    for name, value in {"ICON": icon, "FILES": files, "SCRIPT": script}.items():
        text = text.replace(f"@{name}@", value)
    return text


def embedded(name):
    return f'<script type="text/plain" id="{name}">{base64.b64encode(packed[name]).decode()}</script>'


folder = dist / "web"
shutil.rmtree(folder, ignore_errors=True)
folder.mkdir(parents=True)
for name in names:
    (folder / f"{name}.gz").write_bytes(packed[name])
(folder / "index.html").write_text(page(""), encoding="utf-8")
for name, licence in (pair.split("=", 1) for pair in sys.argv[3:]):
    (folder / "licences").mkdir(exist_ok=True)
    shutil.copyfile(licence, folder / "licences" / f"{name}.txt")
(dist / "braitenlab-web.html").write_text(page("\n".join(map(embedded, names))), encoding="utf-8")

size = sum(map(len, packed.values())) + (folder / "index.html").stat().st_size
print(f"{folder}: {size / 1e6:.2f} MB")
