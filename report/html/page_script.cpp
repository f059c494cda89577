#include "report/html/page_script.hpp"

#include <cstdlib>

#include "core/png.hpp"

namespace clast::report_detail {
namespace {

constexpr int kLevel = 6;  // a third of the time of 9, 1 % larger

// Browsers have an inflate of their own only since 2023, and it makes everything after it wait.
// A code of up to `most` bits is looked up at once: an entry holds the symbol and its length.
constexpr const char* kUnpackScript = R"js(
var clastUnpacked=(function(){
  var order=[16,17,18,0,8,7,9,6,10,5,11,4,12,3,13,2,14,1,15];
  function table(lengths){
    var most=0,counts=[],next=[],code=0,i,l;
    for(i=0;i<16;i++)counts[i]=0;
    for(i=0;i<lengths.length;i++)if(lengths[i]){counts[lengths[i]]++;most=Math.max(most,lengths[i])}
    for(l=1;l<=most;l++){code=(code+(l>1?counts[l-1]:0))<<1;next[l]=code}
    var entries=new Uint16Array(1<<most);
    for(i=0;i<lengths.length;i++){
      l=lengths[i];if(!l)continue;
      var bits=next[l]++,turned=0;
      for(var k=0;k<l;k++)turned|=(bits>>k&1)<<(l-1-k);
      for(;turned<entries.length;turned+=1<<l)entries[turned]=i<<4|l;
    }
    return {most:most,entries:entries};
  }
  function inflate(bytes,out){
    var at=2,to=0,hold=0,held=0,last=0,type,i;
    function bits(n){
      while(held<n){hold|=bytes[at++]<<held;held+=8}
      var value=hold&(1<<n)-1;hold>>>=n;held-=n;return value;
    }
    function symbol(codes){
      while(held<codes.most){hold|=bytes[at++]<<held;held+=8}
      var entry=codes.entries[hold&(1<<codes.most)-1];
      hold>>>=entry&15;held-=entry&15;return entry>>4;
    }
    function even(count,length,into){for(var n=0;n<count;n++)into.push(length);return into}
    while(!last){
      last=bits(1);type=bits(2);
      if(type===0){
        at-=held>>3;hold=held=0;
        var size=bytes[at]|bytes[at+1]<<8;at+=4;
        out.set(bytes.subarray(at,at+size),to);at+=size;to+=size;continue;
      }
      var lengths=[],literals=288,distances;
      if(type===1){
        even(144,8,lengths);even(112,9,lengths);even(24,7,lengths);even(8,8,lengths);even(30,5,lengths);
      }else{
        literals=bits(5)+257;distances=bits(5)+1;
        var small=even(19,0,[]);
        for(i=bits(4)+4,type=0;type<i;type++)small[order[type]]=bits(3);
        small=table(small);
        while(lengths.length<literals+distances){
          var s=symbol(small);
          if(s<16)lengths.push(s);
          else if(s===16)even(3+bits(2),lengths[lengths.length-1],lengths);
          else even(s===17?3+bits(3):11+bits(7),0,lengths);
        }
      }
      var text=table(lengths.slice(0,literals)),back=table(lengths.slice(literals));
      for(;;){
        var letter=symbol(text);
        if(letter===256)break;
        if(letter<256){out[to++]=letter;continue}
        letter-=257;
        var more=letter<8||letter===28?0:(letter>>2)-1;
        var count=letter===28?258:letter<8?letter+3:(4+(letter&3)<<more)+3;
        count+=bits(more);
        var far=symbol(back),wide=far<4?0:(far>>1)-1;
        var from=to-((far<4?far:(2+(far&1))<<wide)+1+bits(wide));
        while(count--)out[to++]=out[from++];
      }
    }
    return out;
  }
  return function(id){
    var element=document.getElementById(id),raw=atob(element.textContent),bytes=new Uint8Array(raw.length);
    for(var i=0;i<raw.length;i++)bytes[i]=raw.charCodeAt(i);
    return new TextDecoder().decode(inflate(bytes,new Uint8Array(+element.dataset.size)));
  };
})();
function clastRun(id){
  if(clastRun[id])return;
  clastRun[id]=true;
  var script=document.createElement('script');script.textContent=clastUnpacked(id);
  document.head.appendChild(script);
}
)js";

}  // namespace

std::string script_element(std::string code) {
  for (std::size_t at = 0; (at = code.find("</", at)) != std::string::npos; at += 3) {
    code.insert(at + 1, 1, '\\');
  }
  return "<script>" + code + "</script>\n";
}

std::string json_element(const std::string& attributes, std::string json) {
  // A "<" is inside a string wherever it is in JSON, and this is how strings may write it.
  for (std::size_t at = 0; (at = json.find('<', at)) != std::string::npos; at += 6) {
    json.replace(at, 1, "\\u003c");
  }
  return "<script type=\"application/json\" " + attributes + ">" + json + "</script>\n";
}

std::string packed_element(const std::string& id, std::string_view text) {
  return "<script type=\"text/plain\" id=\"" + id + "\" data-size=\"" +
         std::to_string(text.size()) + "\">" + base64(deflated(text, kLevel)) + "</script>\n";
}

std::string unpack_script() { return script_element(kUnpackScript); }

std::string installed_folder(const char* variable, const char* configured) {
  const char* named = std::getenv(variable);
  return named && *named ? named : configured;
}

}  // namespace clast::report_detail
